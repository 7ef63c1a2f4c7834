//! Text below the help of each command. Lines are shorter than 80 columns, so that a terminal does not break a
//! command at a place that a shell does not accept.

pub const TOP: &str = "\
Examples:
  percuss check models/six_r_arm.urdf
  percuss mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 \\
      --normal 1,0,0
  percuss damp --mass 12kg --stiffness 400N/mm --restitution 0.4 --for mujoco
  percuss completions bash > /etc/bash_completion.d/percuss

Exit codes: 0 a result (immovable and massless are results), 1 no result,
2 invalid input or usage.";

pub const CHECK: &str = "\
Examples:
  percuss check models/double_pendulum.urdf
  percuss check robot.urdf --format json
  xacro robot.urdf.xacro | percuss check -
  percuss check robot.urdf --strict          warnings as errors (exit 2)";

pub const MASS: &str = "\
Examples:
  A pendulum hits a stop 0.8 m below its hinge:
    percuss mass models/point_mass_pendulum.urdf --link rod \\
        --point 0,0,-0.8 --normal 1,0,0
  An arm in a pose, its tool pushed down along the world's z:
    percuss mass models/six_r_arm.urdf --link tool --point 0.08,0,0 \\
        --normal 0,0,-1 --normal-frame world \\
        --set shoulder=-40deg --set elbow=70deg
  At a spring seat, along the line to the opposite seat on another link:
    percuss mass models/double_wishbone.urdf --link spring_seat \\
        --point 0,0,0 --along-line spring_chassis_seat:0,0,0
  With the classical estimate and its error:
    percuss mass models/double_wishbone.urdf --link spring_seat \\
        --point 0,0,0 --along-line spring_chassis_seat:0,0,0 \\
        --estimate wheel,spindle,upright:0,0,0:0,0,1
  With the damper for a restitution (more in percuss damp):
    percuss mass models/double_wishbone.urdf --link bump_stop_pad \\
        --point 0,0,0 --along-line bump_stop:0,0,0 --against chassis \\
        --restitution 0.3 --stiffness 200N/mm --speed 0.5
  Against a free body of 2 kg:
    percuss mass models/physical_pendulum.urdf --link body \\
        --point 0,0,-0.5 --normal 1,0,0 --against-mass 2kg
  In a regression test, compared with a closed form:
    percuss mass models/point_mass_pendulum.urdf --link rod \\
        --point 0,0,-0.8 --normal 1,0,0 --expect 0.78125

Numbers are SI; deg, rad, mm, cm, m, g, kg may follow them. The normal points
out of the contact link into the other body; its length does not matter.";

pub const SWEEP: &str = "\
Examples:
  Over a joint's range, as CSV:
    percuss sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 \\
        --normal 0,1,0 --vary crank_hinge=0:360deg:361
  Over the travel of a wheel's centre, as a plot:
    percuss sweep models/double_wishbone.urdf --link spring_seat \\
        --point 0,0,0 --along-line spring_chassis_seat:0,0,0 \\
        --turning-normal --vary travel:spindle:0,0,0:0,0,1=-80mm:80mm:161 \\
        --estimate wheel,spindle,upright --output travel.svg
  Every combination of two ranges; the first varies slowest:
    percuss sweep models/six_r_arm.urdf --link tool --point 0.08,0,0 \\
        --normal 0,0,-1 --vary shoulder=-40deg:40deg:41 \\
        --vary elbow=0:90deg:91 --output grid.csv
  Along a path from a file, a column for each joint:
    percuss sweep models/double_wishbone.urdf --link spring_seat \\
        --point 0,0,0 --along-line spring_chassis_seat:0,0,0 \\
        --turning-normal --input path.csv --ignore time
  At random positions within the limits of the joints:
    percuss sweep models/six_r_arm.urdf --link tool --point 0.08,0,0 \\
        --normal 0,0,-1 --random 100000 --seed 1 --output rows.jsonl

The first line of a file of positions contains the joint names. A unit other
than SI follows the name: elbow [deg],spin. A joint with several numbers has
the columns NAME[0], NAME[1], … Joints that depend on loops have no column.

The file extension selects the format: .csv, .json, .jsonl (one JSON object
per line), .svg or .png; without --output, CSV goes to stdout. A file is
replaced only after all rows are written. A row that cannot be reached is
marked and the sweep continues; exit 1 if no row can be reached.

In a mechanism with loops, each row of a range or a file starts from the
previous row. Each line of a grid starts again, and random rows are
independent.";

pub const COMPARE: &str = "\
Examples:
  Two suspensions at their bump stop, over the wheel's travel:
    percuss compare models/suspensions/double-wishbone.toml \\
        models/suspensions/double-wishbone-rods.toml \\
        --link bump_stop_pad --point 0,0,0 --normal 0,-15,80 \\
        --normal-frame against --against chassis \\
        --vary travel:spindle:0,0,0:0,0,1=-20mm:40mm:61 \\
        --output both.svg
  A study and its [[variant]]s, as a table:
    percuss compare models/studies/variants.toml --format csv

All designs are compared with the first one.";

pub const MAP: &str = "\
Examples:
  The surface of one link, as a table and as a picture from two sides:
    percuss map models/shaped_arm.urdf --link forearm -o forearm.png
  A whole robot in a pose, for MeshLab, Blender or a web page:
    percuss map robot.urdf --all --set elbow=70deg -o skin.ply -o skin.glb
  With meshes in a ROS package:
    percuss map robot.urdf --all --package my_robot=/opt/robots/my_robot
  Against another link of the same mechanism; every contact as CSV:
    percuss map models/shaped_arm.urdf --link forearm --against pedestal \\
        --format csv
  All directions at one point: the belted ellipsoid:
    percuss map models/shaped_arm.urdf --link forearm --point 0.3,0,0 \\
        --directions 2000

Contacts are the centres of facets, along their outward normals. The colour
scale is viridis; logarithmic if the masses differ by more than a factor of 20.";

pub const TEMPLATE: &str = "\
Examples:
  percuss template --list
  percuss template double-wishbone -o my.toml
  percuss template macpherson-strut --unit m --axes adams -o strut.toml

Complete the sheet, then convert it to a model:
  percuss import my.toml -o my.urdf

docs/reference/SUSPENSIONS.md explains every key.";

pub const KINEMATICS: &str = "\
Examples:
  percuss kinematics models/suspensions/double-wishbone.toml
  percuss kinematics models/suspensions/double-wishbone.toml \\
      --wheel-travel -50mm:50mm:11 --format csv -o travel.csv
  percuss kinematics models/suspensions/double-wishbone.toml --axle front \\
      --brake-bias 60% --cg-height 500mm --wheelbase 2.7m --sprung-mass 350kg

Definitions of ISO 8855 and SAE J670, in the axes of the vehicle; positive are:
  camber                top of the wheel outward
  toe                   front of the wheel inward (toe-in)
  caster                top of the steering axis backward
  kingpin inclination   top of the steering axis inward
  scrub radius          axis meets the ground inside of the contact point
  mechanical trail      axis meets the ground in front of the contact point
  half-track change     contact point moves outward
  forward displacement  contact point moves forward
  side view angle       path of the rising contact point leans forward
  motion ratio          compression of the spring, or closing of the gap, when
                        the wheel rises
docs/howto/KINEMATICS.md defines all columns.";

pub const IMPORT: &str = "\
Examples:
  percuss import my.toml -o my.urdf
  percuss import my.toml -o both.urdf --side both
  A hardpoint moved by 5 mm:
    percuss import my.toml -o variant.urdf --move lower_ball=0,0,5mm
  A table of hardpoints and masses (rows of names and numbers):
    percuss import my.csv --template double-wishbone --unit mm --axes iso \\
        -o my.urdf
  A suspension file of Chrono::Vehicle, in m (the default) or in mm:
    percuss import Sedan_DoubleWishbone.json -o axle.urdf --side both \\
        --wheel-mass 18kg --wheel-inertia 0.6,1.1,0.6 --wheel-radius 0.31
    percuss import corner_mm.json --unit mm -o corner.urdf

The imported data are printed for comparison with the drawing. percuss
template writes a blank sheet. Supported templates of Chrono: DoubleWishbone,
DoubleWishboneReduced, MacPhersonStrut, SemiTrailingArm, ThreeLinkIRS,
MultiLink. docs/reference/SUSPENSIONS.md lists the bodies, joints and frames
of each.";

pub const DAMP: &str = "\
Examples:
  Steel on a rubber stop, 12 kg effective mass:
    percuss damp --mass 12kg --stiffness 400N/mm --restitution 0.4 --speed 0.5
  A Hertz contact: k in N/m^1.5, damper force c x^(1/4) v:
    percuss damp --mass 12kg --stiffness 1e8 --exponent 1.5 --restitution 0.4 \\
        --speed 0.5
  For MuJoCo and Drake, ready to paste:
    percuss damp --mass 12kg --stiffness 400N/mm --restitution 0.4 \\
        --speed 0.5 --for mujoco,drake
  A suspension on its bump stop, from the model:
    percuss damp --mass-from models/double_wishbone.urdf \\
        --link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 \\
        --against chassis --stiffness 200N/mm --restitution 0.3 --speed 0.5
  Force over time and penetration, and the list of laws:
    percuss damp --mass 12kg --stiffness 400N/mm --restitution 0.4 \\
        --speed 0.5 --output impact.svg
    percuss damp --list-laws

The default law is the linear damper, solved exactly; the contact ends when
the force vanishes, because a contact does not pull and simulators set the
force to 0 there. --separation gap is the half-period formula of textbooks.";

pub const RESTITUTION: &str = "\
Examples:
  percuss restitution --mass 12kg --stiffness 400N/mm --damping 900 \\
      --speed 0.2,0.5,1 --load 120
  Of parameters of a simulator, with the mass from a model:
    percuss restitution models/double_wishbone.urdf --link bump_stop_pad \\
        --point 0,0,0 --along-line bump_stop:0,0,0 --against chassis \\
        --tool ode --parameter soft_erp=0.2 --parameter soft_cfm=1e-5 \\
        --parameter time_step=0.001 --speed 0.5

The names of the parameters are those that percuss damp --for NAME writes.";

pub const IDENTIFY: &str = "\
Examples:
  percuss identify drop.csv --drop 300mm -o fit.svg
  Several impacts of one contact, filtered, compared with a model:
    percuss identify slow.csv fast.csv --filter 600 \\
        --mass-from models/double_wishbone.toml --at bump_stop
  A file begins with its columns: time [ms], force [kN], acceleration [g]

The motion is that of a constant mass on k x^p and a damper. A force with
another signal, or with a known speed, determines the mass.";

pub const RESPONSE: &str = "\
Examples:
  percuss response models/suspensions/double-wishbone-bushes.toml \\
      --at bump_stop --frequency 1:2000Hz:400 -o response.svg

Without bushes the apparent mass is the effective mass at every frequency.";

pub const SAFE_SPEED: &str = "\
Examples:
  percuss safe-speed models/six_r_arm.urdf --link tool --point 0.08,0,0 \\
      --normal 1,0,0 --set elbow=70deg --region chest --force 280 --load 2kg
  percuss safe-speed --list-regions

An engineering aid, not a certification. Take the limits of force or pressure
from the edition of the standard that applies to you. The table of regions is
informative.";

pub const CONVERT: &str = "\
Examples:
  percuss convert models/four_bar.urdf -o four_bar.xml
  percuss convert robot.xml -o robot.urdf
  percuss convert robot.urdf -o robot.sdf
  percuss convert my.toml --to mjcf -o - > suspension.xml

Loops, mimics, armatures and shapes are kept. Meshes are not copied.";

pub const EXPORT: &str = "\
Examples:
  percuss export models/four_bar.urdf --link coupler --point 0.2,0,0 \\
      --normal 1,0,0 --set crank_hinge=60deg --restitution 0.3 \\
      --stiffness 1e6 -o impact.xml
  python impact.py
  percuss export front.toml --at bump_stop_left --restitution 0.2 \\
      --stiffness 400N/mm --speed 0.1 -o front.xml
  percuss export front.toml -o front.sdf

Without a contact, the result is that of percuss convert, in any format.
The script needs the package mujoco. It exits with 1 if the restitution differs
by more than 0.001.";

pub const EXPLORE: &str = "\
Examples:
  A page of a suspension at its bump stop, opened in the browser:
    percuss explore models/suspensions/double-wishbone.toml --open
  A robot arm, with a contact at the tool:
    percuss explore models/six_r_arm.urdf --link tool --point 0.08,0,0 \\
        --normal 0,0,-1 -o arm.html
  A study with its contact, pose and variants:
    percuss explore models/studies/report.toml
  See docs/howto/EXPLORER.md.";

pub const GENERATE: &str = "\
Examples:
  C code for a controller, with its self-test:
    percuss generate models/six_r_arm.urdf --link tool --point 0.08,0,0 \\
        --normal 0,0,-1 -o generated
    cc -O2 generated/six_r_arm.c generated/six_r_arm_test.c -lm && ./a.out
  Many configurations in one call, compiled for vector registers:
    percuss generate models/six_r_arm.urdf --link tool --point 0.08,0,0 \\
        --normal 0,0,-1 --batch -o generated
  A linkage: the code closes the loops from the driving joints:
    percuss generate models/four_bar.urdf --link coupler \\
        --point 0.35,0.1,0 --normal 0,1,0 --close -o generated

The code returns a status where a configuration has no result. Loops: the
independent rows are chosen at the pose of --set and --guess.";

pub const INIT: &str = "\
Examples:
  percuss init models/six_r_arm.urdf -o arm.toml
  percuss run arm.toml
  percuss run arm.toml --report arm.html
  For a suspension sheet, the contact is the bump stop:
    percuss init models/suspensions/double-wishbone.toml -o stop.toml

The path of the model is relative to the study. The study contains all other
keys as comments; docs/reference/STUDIES.md explains every key.";

pub const RUN: &str = "\
Examples:
  The sweep of the study, if any, otherwise the contact:
    percuss run models/four_bar.toml
  The contact at the pose of the study, with its damper if any:
    percuss run models/four_bar.toml --format json
  One page with all results, in the folder of the study:
    percuss run arm.toml --report arm.html

The parts of a study run in this order: the contact (over its [sweep] or with
its [[variant]]s), the stop of a joint, the [map], the [safe_speed].";

pub const IMPACT: &str = "\
Examples:
  percuss impact models/four_bar.urdf --link coupler --point 0.35,0.1,0 \\
      --normal 0,1,0 --restitution 0.3 --speed 2
  percuss impact models/four_bar.urdf --link coupler --point 0.35,0.1,0 \\
      --normal 0,1,0 --restitution 0.3 --rates crank_hinge=-120deg/s
  percuss impact models/planar_2r.urdf --link outer --point 0.4,0,0 \\
      --normal 0,1,0 --set elbow=40deg --restitution 0.1 --speed 1 \\
      --stiffness 200N/mm --reflected shoulder --percussion shoulder:1,0,0";

pub const EXTREMES: &str = "\
Examples:
  percuss extremes models/planar_2r.urdf --link outer --point 0.4,0,0 \\
      --normal 0,1,0 --normal-frame world --range shoulder=-180deg:180deg \\
      --range elbow=20deg:160deg
  The limits of the file, more starts:
    percuss extremes models/six_r_arm.urdf --link tool --point 0,0,0 \\
      --normal 0,0,1 --starts 200
  The self-motion with the tool point in place:
    percuss extremes models/six_r_arm.urdf --link tool --point 0.08,0,0 \\
      --normal 0,0,-1 --set elbow=70deg --keep tool:0.08,0,0
  Over the travel of a wheel:
    percuss extremes models/suspensions/double-wishbone.toml \\
      --at spring --wheel-travel=-80mm:80mm:17";

#[cfg(test)]
mod tests {
    #[test]
    fn example_lines_fit_a_terminal() {
        for text in [
            super::TOP,
            super::CHECK,
            super::MASS,
            super::SWEEP,
            super::MAP,
            super::KINEMATICS,
            super::TEMPLATE,
            super::IMPORT,
            super::DAMP,
            super::RESTITUTION,
            super::SAFE_SPEED,
            super::EXPLORE,
            super::GENERATE,
            super::CONVERT,
            super::EXPORT,
            super::INIT,
            super::RUN,
        ] {
            for line in text.lines() {
                assert!(line.chars().count() < 80, "{line}");
            }
        }
    }
}
