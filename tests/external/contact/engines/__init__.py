"""One module for each engine that exports are run in. A module has

    TOOL            percuss's name of the tool
    engine()        program and version, as the export's `measured` has it; raises Absent where it is not installed
    SOLVERS         {name, as `measured` has it: whatever the module needs}; one key "" where there is but one
    ball(parameters, solver, ball, speed)             an Outcome, or
    pendulum(parameters, solver, pendulum, speed)     raises Refused where the tool cannot have the scene
    four_bar(parameters, solver, four_bar, speed)     only where the tool closes loops
    two_bodies(parameters, solver, bodies, speed)     a lever against a free ball; only where the module has it
    linkage(parameters, solver, linkage, speed)       an open chain of two bodies; only where the module has it
    stop(parameters, solver, stop, speed)             only where percuss writes the stops of joints for the tool
    EXPONENT        of the contact's spring, where it is not 1; optional
    BY_HAND         true where the check does not fail for want of the program; optional
    SNIPPETS        {language: reader(text, parameters)}; optional: whether what is to paste is taken by the tool

A module whose name begins with _ is shared by others. What is built goes to target/external.

`parameters` are those of `percuss damp … --for TOOL --format json`, by the tool's own names, time step included. Nothing in a
module knows a contact law."""
