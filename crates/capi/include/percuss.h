/* percuss: the effective mass of a mechanism at a contact. Made by cbindgen from crates/capi/src; not written by hand. docs/howto/C.md says how it is used. */

#ifndef PERCUSS_H
#define PERCUSS_H

#include <stddef.h>
#include <stdint.h>

/* The version of this header. While the first number is 0, the second changes with every change that programs must be
   compiled again for. */
#define PERCUSS_VERSION "0.1.0"
#define PERCUSS_VERSION_MAJOR 0
#define PERCUSS_VERSION_MINOR 1
#define PERCUSS_VERSION_PATCH 0

/* A compiler of C++17 or C23 warns of a status that is not read. */
#ifndef PERCUSS_NODISCARD
#if (defined(__cplusplus) && __cplusplus >= 201703L) || (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 202311L)
#define PERCUSS_NODISCARD [[nodiscard]]
#else
#define PERCUSS_NODISCARD
#endif
#endif

/* No link: the ground. */
#define PERCUSS_GROUND SIZE_MAX

/* No link is given: the link of a contact before it is set. */
#define PERCUSS_NO_LINK (SIZE_MAX - 1)

/*
 Information; nothing is wrong.
 */
#define PERCUSS_NOTE 0

/*
 Probable mistake; the message states the value in use.
 */
#define PERCUSS_WARNING 1

/*
 The root link is the ground.
 */
#define PERCUSS_BASE_FIXED 0

/*
 The root link moves freely.
 */
#define PERCUSS_BASE_FLOATING 1

/*
 The gap hardly closes: m̄ is large and uncertain.
 */
#define PERCUSS_REMARK_NEARLY_IMMOVABLE 1

/*
 Some motions have no mass. They do not affect a finite m̄.
 */
#define PERCUSS_REMARK_MASSLESS_MOTIONS 2

/*
 The contact is massless to rounding only.
 */
#define PERCUSS_REMARK_MASSLESS_TO_ROUNDING 4

/*
 A massless motion leaves v* undetermined; m̄ and the contributions are determined.
 */
#define PERCUSS_REMARK_UNDETERMINED_MOTION 8

/*
 The rank of the constraints is unclear.
 */
#define PERCUSS_REMARK_UNCLEAR_RANK 16

/*
 The mass matrix has negative directions: m̄ is a stationary value, not a minimum.
 */
#define PERCUSS_REMARK_INDEFINITE 32

/*
 Branches cross at this pose: m̄ is a lower bound that no branch attains.
 */
#define PERCUSS_REMARK_SINGULAR_POSE 64

/*
 The pose is on another assembly mode than the first closed pose (percuss_configuration_allow_other_assembly).
 */
#define PERCUSS_REMARK_OTHER_ASSEMBLY 128

/*
 A loop is open as drawn by more than a hundredth of its size: a point may be mistyped.
 */
#define PERCUSS_REMARK_DRAWN_OPEN 256

/*
 The loops contradict one another within rounding: closed in least squares.
 */
#define PERCUSS_REMARK_INEXACT_LOOPS 512

/*
 A driving joint was not set, and 0 is out of reach.
 */
#define PERCUSS_REMARK_DRIVER_OFF_ZERO 1024

/*
 A joint was set to more numbers than its loops leave degrees of freedom: the nearest position is used.
 */
#define PERCUSS_REMARK_OFF_TARGET 2048

/*
 A joint is outside its limits. Workspaces do not check limits.
 */
#define PERCUSS_REMARK_OUTSIDE_LIMITS 4096

/*
 A small error in the file's numbers would leave the loops one more degree of freedom.
 */
#define PERCUSS_REMARK_WEAKLY_CONSTRAINED 8192

/*
 The generic rank of the constraints is unclear: the mobility may differ.
 */
#define PERCUSS_REMARK_UNCLEAR_MOBILITY 16384

/*
 The normal is given in the world and the base floats, but the base pose was not given: the root link is taken at the
 world's origin (percuss_configuration_set_base, percuss_workspace_set_base).
 */
#define PERCUSS_REMARK_BASE_NOT_GIVEN 32768

/*
 In batches, a row without an answer: a position is not finite.
 */
#define PERCUSS_REMARK_NOT_FINITE 65536

/*
 In batches, a row without an answer: a quaternion is not of unit length.
 */
#define PERCUSS_REMARK_NOT_UNIT_QUATERNION 131072

/*
 In batches, a row without an answer: a loop is open.
 */
#define PERCUSS_REMARK_OPEN_LOOPS 262144

/*
 In batches, a row without an answer for another reason.
 */
#define PERCUSS_REMARK_NO_ANSWER 524288

/*
 The error of m̄ is above 1e-6 m̄; the gradient is not computed.
 */
#define PERCUSS_REMARK_UNCERTAIN_MASS 1048576

/*
 The error of m̄ is unknown.
 */
#define PERCUSS_REMARK_UNKNOWN_ERROR 2097152

/*
 The contact is a named contact whose gap is open at this pose: an impact occurs at the touch, with the m̄ there (percuss_pose_touch).
 */
#define PERCUSS_REMARK_OPEN_GAP 4194304

/*
 A joint outside its limits is more than a turn from 0: its position, in rad, is probably a number of degrees.
 */
#define PERCUSS_REMARK_MANY_TURNS 8388608

/*
 F = k xᵖ + c x^((p−1)/2) ẋ.
 */
#define PERCUSS_DAMPER_KELVIN_VOIGT 0

/*
 F = k xᵖ (1 + d ẋ).
 */
#define PERCUSS_DAMPER_HUNT_CROSSLEY 1

/*
 F = k xᵖ (1 + (π/2) η sgn ẋ).
 */
#define PERCUSS_DAMPER_LOSS_FACTOR 2

/*
 The position of the axle is unknown: no support angles.
 */
#define PERCUSS_AXLE_UNKNOWN 0

/*
 Front axle.
 */
#define PERCUSS_AXLE_FRONT 1

/*
 Rear axle.
 */
#define PERCUSS_AXLE_REAR 2

/*
 No motions per load.
 */
#define PERCUSS_LOADS_NONE 0

/*
 Loads on a single wheel, on the right wheel the mirror image.
 */
#define PERCUSS_LOADS_SINGLE 1

/*
 The same load on both wheels.
 */
#define PERCUSS_LOADS_PARALLEL 2

/*
 Opposite loads on both wheels, positive on the left.
 */
#define PERCUSS_LOADS_OPPOSED 3

/*
 Added to PERCUSS_LOADS_SINGLE and the following: the heights of the wheel centres are held.
 */
#define PERCUSS_TRAVEL_HELD 8

/*
 Value of an option of percuss_matrix_options for its default.
 */
#define PERCUSS_DEFAULT -1.0

/*
 A system with assembled loops. Immutable, so that threads can share it.
 */
typedef struct percuss_assembly percuss_assembly;

/*
 One contact, prepared for many configurations. Immutable, so that threads can share it.
 */
typedef struct percuss_batch percuss_batch;

/*
 Links, joints and closures of a model that is being built. One thread at a time.
 */
typedef struct percuss_builder percuss_builder;

/*
 Conditions of an analysis. One thread at a time.
 */
typedef struct percuss_conditions percuss_conditions;

/*
 Positions of the joints, and pose of the root link in the world. One thread at a time.
 */
typedef struct percuss_configuration percuss_configuration;

/*
 Quantities of a suspension, one row per state. Immutable, so that threads can share it.
 */
typedef struct percuss_kinematics percuss_kinematics;

/*
 A mechanism. Immutable, so that threads can share it.
 */
typedef struct percuss_model percuss_model;

/*
 A contact of a linkage whose driving joints follow a path. One thread at a time.
 */
typedef struct percuss_path percuss_path;

/*
 A mechanism at one configuration with closed loops. Immutable, so that threads can share it.
 */
typedef struct percuss_pose percuss_pose;

/*
 The results of a request, as JSON. Immutable, so that threads can share it.
 */
typedef struct percuss_report percuss_report;

/*
 A response to a contact: m̄, v*, contributions. Immutable, so that threads can share it.
 */
typedef struct percuss_response percuss_response;

/*
 A suspension read from its sheet. Immutable, so that threads can share it.
 */
typedef struct percuss_suspension percuss_suspension;

/*
 A mechanism under conditions. Immutable, so that threads can share it.
 */
typedef struct percuss_system percuss_system;

/*
 Workspace for m̄ at many poses of an assembly. One thread at a time: each thread needs its own.
 */
typedef struct percuss_workspace percuss_workspace;

/*
 Status of a call: PERCUSS_OK, or one of the errors.
 */
typedef int32_t percuss_status;

/*
 Kind of a joint.
 */
typedef int32_t percuss_joint_kind;

/*
 A joint.
 */
typedef struct percuss_joint {
  /*
   Its name; valid as long as the model.
   */
  const char *name;
  /*
   A percuss_joint_kind.
   */
  percuss_joint_kind kind;
  /*
   1 if the joint has limits.
   */
  int32_t has_limits;
  /*
   Least and greatest position (rad or m); NaN without limits.
   */
  double lower;
  /*
   See lower.
   */
  double upper;
  /*
   Number of positions of the joint, and index of its first position in the mechanism's position vector.
   */
  size_t positions;
  /*
   See positions.
   */
  size_t first_position;
  /*
   Number of velocities of the joint, and index of its first velocity in the mechanism's velocity vector.
   */
  size_t velocities;
  /*
   See velocities.
   */
  size_t first_velocity;
  /*
   Numbers of the parent link and the child link.
   */
  size_t parent;
  /*
   See parent.
   */
  size_t child;
} percuss_joint;

/*
 Finding about a file or a pose.
 */
typedef struct percuss_diagnostic {
  /*
   PERCUSS_NOTE or PERCUSS_WARNING; errors make the load fail.
   */
  int32_t severity;
  /*
   Line, from 1; 0 if unknown.
   */
  uint32_t line;
  /*
   Column in characters, from 1; 0 if unknown.
   */
  uint32_t column;
  /*
   Stable short name, for programs. The texts are valid as long as the model or the pose.
   */
  const char *code;
  /*
   The finding.
   */
  const char *message;
  /*
   The file.
   */
  const char *path;
} percuss_diagnostic;

/*
 Description of a joint. Initialise it with percuss_joint_description_init. Texts are UTF-8, end with a zero byte and are read during
 percuss_builder_joint only.
 */
typedef struct percuss_joint_description {
  /*
   Unique name.
   */
  const char *name;
  /*
   Name of the parent link.
   */
  const char *parent;
  /*
   Name of the child link.
   */
  const char *child;
  /*
   A percuss_joint_kind.
   */
  percuss_joint_kind kind;
  /*
   Number of armature values that are read: 0, 1 (the same for all velocities), or one per velocity, at most 6.
   */
  int32_t armature_count;
  /*
   Origin of the joint frame in the parent link, m.
   */
  double position[3];
  /*
   Orientation of the joint frame in the parent link: unit quaternion w, x, y, z.
   */
  double quaternion[4];
  /*
   Axis in the joint frame, of any length.
   */
  double axis[3];
  /*
   Smallest position, rad or m; lower and upper are NaN without limits.
   */
  double lower;
  /*
   Largest position, rad or m.
   */
  double upper;
  /*
   Rotor inertias reflected to the joint, kg·m² or kg.
   */
  double armature[6];
  /*
   Name of the joint that this joint follows, or null: q = multiplier · q of that joint + offset.
   */
  const char *mimics;
  /*
   See mimics.
   */
  double multiplier;
  /*
   See mimics.
   */
  double offset;
} percuss_joint_description;

/*
 Kind of a closure: the relative motion that it leaves.
 */
typedef int32_t percuss_closure_kind;

/*
 Description of a closure: a joint that closes a loop. Initialise it with percuss_closure_description_init. Texts as in
 percuss_joint_description.
 */
typedef struct percuss_closure_description {
  /*
   Unique name.
   */
  const char *name;
  /*
   Name of the predecessor link; "world" is the ground, unless a link has this name.
   */
  const char *predecessor;
  /*
   Name of the successor link.
   */
  const char *successor;
  /*
   A percuss_closure_kind.
   */
  percuss_closure_kind kind;
  /*
   0.
   */
  int32_t reserved;
  /*
   Origin of the loop frame in the predecessor, m.
   */
  double predecessor_position[3];
  /*
   Orientation of the loop frame in the predecessor: unit quaternion w, x, y, z.
   */
  double predecessor_quaternion[4];
  /*
   Origin of the loop frame in the successor, m.
   */
  double successor_position[3];
  /*
   Orientation of the loop frame in the successor: unit quaternion w, x, y, z.
   */
  double successor_quaternion[4];
  /*
   Axis, with the same components in both loop frames.
   */
  double axis[3];
  /*
   Second axis of a universal closure, in the successor's loop frame.
   */
  double axis2[3];
  /*
   Length of a distance closure, m; NaN: the distance with all joints at 0.
   */
  double distance;
} percuss_closure_description;

/*
 Frame or kind of a normal.
 */
typedef int32_t percuss_normal;

/*
 A contact between a point of a link and another link, or the ground. Initialise it with percuss_contact_init.
 */
typedef struct percuss_contact {
  /*
   The contact link: a number of percuss_model_find_link. PERCUSS_NO_LINK, from percuss_contact_init, is an error.
   */
  size_t link;
  /*
   The other side: a link, or PERCUSS_GROUND.
   */
  size_t against;
  /*
   The contact point in the contact link's frame, m.
   */
  double point[3];
  /*
   The normal, out of the contact link into the other side; its length does not matter. For PERCUSS_NORMAL_TOWARD,
   PERCUSS_NORMAL_TURNING_TOWARD and PERCUSS_NORMAL_TURNING_AWAY: a point of the line, m.
   */
  double normal[3];
  /*
   Kind of the normal: PERCUSS_NORMAL_LINK to PERCUSS_NORMAL_TURNING_AWAY; or PERCUSS_AXIS_LINK to PERCUSS_AXIS_AGAINST.
   */
  percuss_normal normal_given;
  /*
   Link of that point; not read if the normal is a vector.
   */
  size_t toward;
} percuss_contact;

/*
 Method of computing m̄.
 */
typedef int32_t percuss_route;

/*
 Outcome of a contact: resistance of the mechanism to the closing motion.
 */
typedef int32_t percuss_outcome;

/*
 Effective mass with its error and remarks. An unknown or inapplicable number is NaN.
 */
typedef struct percuss_mass {
  /*
   A percuss_outcome.
   */
  percuss_outcome outcome;
  /*
   PERCUSS_ROUTE_DENSE or PERCUSS_ROUTE_ARTICULATED.
   */
  percuss_route route;
  /*
   PERCUSS_REMARK_… added together.
   */
  uint32_t remarks;
  /*
   0.
   */
  uint32_t reserved;
  /*
   Degrees of freedom left by the constraints; a floating base's 6 included.
   */
  size_t degrees_of_freedom;
  /*
   m̄, kg; NaN unless the outcome is PERCUSS_FINITE.
   */
  double effective_mass;
  /*
   Error of m̄, kg: the sum of the known parts. NaN if the rounding or the closing part is unknown.
   */
  double error;
  /*
   Part by rounding, kg.
   */
  double error_rounding;
  /*
   Part by the residual of the loops, kg.
   */
  double error_closing;
  /*
   Part by the misfit of the loops in the file, kg; NaN without redundant rows to measure it.
   */
  double error_file;
} percuss_mass;

/*
 Memory order of matrix entries.
 */
typedef int32_t percuss_layout;

/*
 Result of a rigid impact.
 */
typedef struct percuss_rigid_impact {
  /*
   Impulse between the two sides, (1+e) m̄ c, N·s.
   */
  double impulse;
  /*
   Lost kinetic energy, ½ m̄ (1−e²) c², J.
   */
  double energy_loss;
  /*
   Largest unbalanced impulse of the reactions, relative to the impulse.
   */
  double residual;
} percuss_rigid_impact;

/*
 Response of a workspace to a contact.
 */
typedef struct percuss_workspace_response {
  /*
   PERCUSS_FINITE, PERCUSS_IMMOVABLE or PERCUSS_MASSLESS.
   */
  percuss_outcome outcome;
  /*
   PERCUSS_REMARK_… added together.
   */
  uint32_t remarks;
  /*
   m̄, kg; NaN unless finite.
   */
  double effective_mass;
  /*
   Error of m̄ by rounding, kg; NaN unless finite. Those by the closing of loops and by the file: percuss_pose_effective_mass.
   */
  double error;
  /*
   v* of a floating root link: 3 angular and 3 linear numbers, in its axes at its origin; zeros for a fixed root link.
   */
  double base_velocity[6];
} percuss_workspace_response;

/*
 Watch function, called periodically on the calling thread with the number of configurations done. Returns 0 to
 continue; another value stops the work. It must not use the batch and must not throw.
 */
typedef int32_t (*percuss_watch)(size_t done, void *user);

/*
 State of a pose.
 */
typedef struct percuss_pose_state {
  /*
   Degrees of freedom at this pose; a floating base counts 6.
   */
  size_t degrees_of_freedom;
  /*
   Rank of A.
   */
  size_t rank;
  /*
   PERCUSS_REMARK_… about the pose added together: joints outside their limits, the closing of the loops, the rank.
   */
  uint32_t remarks;
  /*
   1 if the rank of A is smaller than at a generic pose: branches cross.
   */
  int32_t is_singular;
  /*
   1 if the rank of A is clear.
   */
  int32_t rank_is_clear;
  /*
   0.
   */
  int32_t reserved;
  /*
   Smallest ratio, over all groups of loops, of the smallest nonzero to the largest zero singular value; NaN without constraints.
   */
  double rank_gap;
  /*
   Largest remaining gap of the loops, m; NaN without loops.
   */
  double closure_residual;
} percuss_pose_state;

/*
 Number of a contact law, from percuss_law_find.
 */
typedef int32_t percuss_law;

/*
 An effective mass and the spring between the two surfaces: force k xᵖ at the penetration x.
 */
typedef struct percuss_spring {
  /*
   m̄, kg.
   */
  double effective_mass;
  /*
   k, N/mᵖ.
   */
  double stiffness;
  /*
   p, 1 to 10: 1 for a linear spring, 1.5 for Hertz's spheres.
   */
  double exponent;
} percuss_spring;

/*
 End of a contact, for a law whose force would pull before the gap closes.
 */
typedef int32_t percuss_separation;

/*
 A damper in parallel with the spring.
 */
typedef struct percuss_damper {
  /*
   PERCUSS_DAMPER_KELVIN_VOIGT, PERCUSS_DAMPER_HUNT_CROSSLEY or PERCUSS_DAMPER_LOSS_FACTOR.
   */
  int32_t kind;
  /*
   End of the contact, for a Kelvin–Voigt damper.
   */
  percuss_separation separation;
  /*
   c of a Kelvin–Voigt damper, N·s/m^((p+1)/2), N·s/m for p = 1; else NaN.
   */
  double coefficient;
  /*
   Damping ratio ζ of a Kelvin–Voigt damper on its design contact; loss factor η; else NaN.
   */
  double ratio;
  /*
   d of a Hunt–Crossley damper, s/m; else NaN.
   */
  double dissipation;
} percuss_damper;

/*
 Characteristics of one impact.
 */
typedef struct percuss_impact {
  /*
   Rebound speed over approach speed.
   */
  double restitution;
  /*
   From the first touch to the end, s; NaN if the gap needs infinite time to close.
   */
  double duration;
  /*
   Greatest penetration, m.
   */
  double max_penetration;
  /*
   From the first touch, s.
   */
  double time_of_max_penetration;
  /*
   Greatest contact force, N.
   */
  double peak_force;
  /*
   From the first touch, s.
   */
  double time_of_peak_force;
  /*
   Dissipated energy, J.
   */
  double energy_lost;
  /*
   Rebound speed, m/s.
   */
  double rebound_speed;
} percuss_impact;

/*
 State of a suspension apart from the variable of the rows, and data of the vehicle.
 */
typedef struct percuss_vehicle {
  /*
   Travels with one value for all rows, m; 0: none.
   */
  double wheel_travel;
  /*
   See wheel_travel.
   */
  double heave;
  /*
   See wheel_travel.
   */
  double roll;
  /*
   Displacement of the rack for all rows, m.
   */
  double steer;
  /*
   PERCUSS_AXLE_….
   */
  int32_t axle;
  /*
   1 for brakes whose torque acts on the vehicle body.
   */
  int32_t inboard_brakes;
  /*
   1 for a drive whose torque acts on the vehicle body.
   */
  int32_t inboard_drive;
  /*
   PERCUSS_LOADS_…, plus PERCUSS_TRAVEL_HELD to hold the heights of the wheel centres: columns of the motions per load (rad/N, m/N, rad/(N·m),
   m/(N·m)) with the bushes of the sheet, such as toe_per_lateral_force.
   */
  int32_t loads;
  /*
   Share of the front axle in the braking force, 0 to 1; NaN if unknown.
   */
  double brake_bias;
  /*
   Share of this axle in the driving force, 0 to 1; NaN if unknown.
   */
  double drive_share;
  /*
   Height of the centre of mass above the ground, m; NaN if unknown.
   */
  double cg_height;
  /*
   Wheelbase, m; NaN if unknown.
   */
  double wheelbase;
  /*
   Sprung mass above one wheel, kg; NaN if unknown.
   */
  double sprung_mass;
  /*
   Vertical rate of the tyre, N/m; NaN if unknown.
   */
  double tyre_rate;
} percuss_vehicle;

/*
 Variable of the rows.
 */
typedef int32_t percuss_wheel_motion;

/*
 Column of a table. The texts are valid as long as the table.
 */
typedef struct percuss_column {
  /*
   The quantity, with _left or _right for one of two wheels: camber, toe_left, motion_ratio_spring, …
   */
  const char *name;
  /*
   SI unit; "" for a plain number.
   */
  const char *unit;
  /*
   Reason for the absence of all values; null if a row has a value.
   */
  const char *missing;
} percuss_column;

/*
 Options for reading matrices. Initialise them with percuss_matrix_options_init.
 */
typedef struct percuss_matrix_options {
  /*
   Scale of each coordinate for rank decisions: displacement per unit rate, in one unit for all coordinates (1 for
   a slide in metres, a typical length for an angle). null: 1 for all.
   */
  const double *lengths;
  /*
   Number of lengths: one per coordinate, or 0.
   */
  size_t length_count;
  /*
   Singular values of A below this fraction of the largest count as zero; above 0, at most 0.1.
   PERCUSS_DEFAULT: 1e-10, or 10 times the accuracy of A if larger; a dropped singular value above rounding then
   makes the rank unclear.
   */
  double rank_floor;
  /*
   Relative error of every entry of M, A and j, 0 to 1e-3; part of the stated error. Default 2.2e-16; matrices stored
   in single precision have 6e-8.
   */
  double accuracy;
  /*
   Relative error of every entry of M. PERCUSS_DEFAULT: accuracy.
   */
  double accuracy_of_mass;
  /*
   Relative error of every entry of A. PERCUSS_DEFAULT: accuracy.
   */
  double accuracy_of_constraints;
  /*
   Relative error of every entry of j. PERCUSS_DEFAULT: accuracy.
   */
  double accuracy_of_contact_row;
  /*
   Rows of A with all entries, divided by lengths, at or below this level count as zero; at least 0; 0: every
   nonzero row counts. PERCUSS_DEFAULT: 1e-14 of the largest entry of the rows that share coordinates.
   */
  double row_noise;
} percuss_matrix_options;

/*
 A matrix of the caller, read in place.
 */
typedef struct percuss_matrix {
  /*
   The entries; null only for an empty matrix.
   */
  const double *values;
  /*
   Number of values: at least (rows − 1) · leading_dimension + columns, row by row; (columns − 1) ·
   leading_dimension + rows, column by column.
   */
  size_t length;
  /*
   Rows.
   */
  size_t rows;
  /*
   Columns.
   */
  size_t columns;
  /*
   Distance between rows (row by row) or columns (column by column), as in BLAS.
   */
  size_t leading_dimension;
  /*
   PERCUSS_ROW_MAJOR or PERCUSS_COLUMN_MAJOR.
   */
  percuss_layout layout;
  /*
   0.
   */
  uint32_t reserved;
} percuss_matrix;

/*
 Rank report of A.
 */
typedef struct percuss_rank {
  /*
   Number of independent rows.
   */
  size_t rank;
  /*
   Number of redundant rows.
   */
  size_t redundant;
  /*
   Least gap between counted singular values and those taken as zero; NaN without rows.
   */
  double gap;
  /*
   1 if no singular value is within a factor of 30 of the threshold.
   */
  int32_t is_clear;
  /*
   0.
   */
  uint32_t reserved;
} percuss_rank;

/*
 Success.
 */
#define PERCUSS_OK 0

/*
 A pointer is null, or not aligned.
 */
#define PERCUSS_ERROR_NULL 1

/*
 A handle has another type. A freed handle is detected only while its memory is not reused.
 */
#define PERCUSS_ERROR_HANDLE 2

/*
 An array has a wrong length, or a matrix a wrong shape or leading dimension.
 */
#define PERCUSS_ERROR_LENGTH 3

/*
 A number is out of range, NaN or infinite without permission, or not a value of its enumeration.
 */
#define PERCUSS_ERROR_ARGUMENT 4

/*
 A text is not UTF-8.
 */
#define PERCUSS_ERROR_TEXT 5

/*
 No link, joint, law or other item has this name or number.
 */
#define PERCUSS_ERROR_NAME 6

/*
 A model cannot be read; the message lists every error with file and line.
 */
#define PERCUSS_ERROR_LOAD 7

/*
 Conditions do not fit the mechanism, or a joint cannot be set to these values.
 */
#define PERCUSS_ERROR_CONDITIONS 8

/*
 Loops do not close, or drivers cannot reach their positions.
 */
#define PERCUSS_ERROR_ASSEMBLY 9

/*
 A contact is invalid, or has no answer.
 */
#define PERCUSS_ERROR_CONTACT 10

/*
 Matrices are invalid: not symmetric, indefinite, too large.
 */
#define PERCUSS_ERROR_MATRIX 11

/*
 A contact law cannot provide the requested damper or impact.
 */
#define PERCUSS_ERROR_LAW 12

/*
 Another thread is using this object.
 */
#define PERCUSS_ERROR_BUSY 13

/*
 The caller stopped the work.
 */
#define PERCUSS_ERROR_STOPPED 14

/*
 Output arrays or values overlap each other or an input.
 */
#define PERCUSS_ERROR_OVERLAP 15

/*
 A defect of percuss. The object in use may only be freed.
 */
#define PERCUSS_ERROR_INTERNAL 99

/*
 Holds its child: no positions, no velocities.
 */
#define PERCUSS_FIXED 0

/*
 A hinge within limits: 1 position, rad.
 */
#define PERCUSS_REVOLUTE 1

/*
 A hinge without limits: 1 position, rad.
 */
#define PERCUSS_CONTINUOUS 2

/*
 A slide: 1 position, m.
 */
#define PERCUSS_PRISMATIC 3

/*
 In a plane: 3 positions x, y (m), θ (rad); 3 velocities.
 */
#define PERCUSS_PLANAR 4

/*
 A ball: 4 positions, a unit quaternion w, x, y, z; 3 velocities (rad/s, child's axes).
 */
#define PERCUSS_SPHERICAL 5

/*
 Free: 7 positions x, y, z (m), w, x, y, z; 6 velocities, 3 angular then 3 linear (child's axes).
 */
#define PERCUSS_FLOATING 6

/*
 The frames coincide.
 */
#define PERCUSS_CLOSURE_FIXED 0

/*
 A hinge about the axis.
 */
#define PERCUSS_CLOSURE_REVOLUTE 1

/*
 A slide along the axis.
 */
#define PERCUSS_CLOSURE_PRISMATIC 2

/*
 Translation along the axis and rotation about it.
 */
#define PERCUSS_CLOSURE_CYLINDRICAL 3

/*
 Rotations about two pins: axis in the predecessor's loop frame, axis2 in the successor's.
 */
#define PERCUSS_CLOSURE_UNIVERSAL 4

/*
 Translations in the plane normal to the axis, rotation about the axis.
 */
#define PERCUSS_CLOSURE_PLANAR 5

/*
 A ball joint.
 */
#define PERCUSS_CLOSURE_SPHERICAL 6

/*
 A massless rod with balls at its ends.
 */
#define PERCUSS_CLOSURE_DISTANCE 7

/*
 A vector in the contact link's frame: it turns with the link.
 */
#define PERCUSS_NORMAL_LINK 0

/*
 A vector in the world's frame.
 */
#define PERCUSS_NORMAL_WORLD 1

/*
 A vector in the other link's frame (the world's frame if the other side is the ground).
 */
#define PERCUSS_NORMAL_AGAINST 2

/*
 From the contact point towards a point (m) of another link, in that link's frame.
 Refused if that line has turned by more than 5° from the line as drawn, or is shorter than a tenth of its drawn
 length.
 */
#define PERCUSS_NORMAL_TOWARD 3

/*
 The same line, which may turn: a spring, a damper or a rod. Refused if shorter than a tenth of its drawn length.
 */
#define PERCUSS_NORMAL_TURNING_TOWARD 4

/*
 The opposite direction of that line: a stop that limits the extension of a damper.
 */
#define PERCUSS_NORMAL_TURNING_AWAY 5

/*
 The axis of a moment in the contact link's frame. The contact is a moment about the axis (a couple): effective masses are inertias
 in kg·m², speeds are in rad/s, and the point has no effect.
 */
#define PERCUSS_AXIS_LINK 6

/*
 The axis of a moment in the world's frame.
 */
#define PERCUSS_AXIS_WORLD 7

/*
 The axis of a moment in the other link's frame (the world's frame if the other side is the ground).
 */
#define PERCUSS_AXIS_AGAINST 8

/*
 A finite effective mass.
 */
#define PERCUSS_FINITE 0

/*
 No admissible motion closes the gap.
 */
#define PERCUSS_IMMOVABLE 1

/*
 A motion without energy closes the gap.
 */
#define PERCUSS_MASSLESS 2

/*
 In batches: no answer. The remarks hold the reason; the error message of percuss_workspace_effective_mass at that
 configuration states it.
 */
#define PERCUSS_NO_ANSWER 3

/*
 In batches: massless to rounding only; the error is the largest possible m̄ of the contact, kg.
 */
#define PERCUSS_MASSLESS_TO_ROUNDING 4

/*
 The recursion if it is accurate enough, else the dense method.
 */
#define PERCUSS_ROUTE_AUTO 0

/*
 Mass matrix, kernel of the constraints, least energy: O(n³).
 */
#define PERCUSS_ROUTE_DENSE 1

/*
 Articulated recursion over clusters: O(n).
 */
#define PERCUSS_ROUTE_ARTICULATED 2

/*
 Row by row: entry (r, c) at r · leading_dimension + c.
 */
#define PERCUSS_ROW_MAJOR 0

/*
 Column by column, as in Fortran and BLAS: entry (r, c) at c · leading_dimension + r.
 */
#define PERCUSS_COLUMN_MAJOR 1

/*
 A spring in parallel with a damper, solved exactly.
 */
#define PERCUSS_LAW_KELVIN_VOIGT 0

/*
 A damper proportional to the spring force, solved exactly.
 */
#define PERCUSS_LAW_HUNT_CROSSLEY 1

/*
 The contact ends when the force has fallen to zero: contacts that do not stick, and simulators that use max(0, F).
 */
#define PERCUSS_FORCE_VANISHES 0

/*
 The contact ends when the spring has its free length again; the damper pulls shortly before.
 */
#define PERCUSS_GAP_CLOSES 1

/*
 Travel of the wheel of one side, m, upward.
 */
#define PERCUSS_WHEEL_TRAVEL 0

/*
 Both wheels upward by the same travel, m.
 */
#define PERCUSS_HEAVE 1

/*
 The left wheel upward and the right wheel downward, m.
 */
#define PERCUSS_ROLL 2

/*
 Displacement of the rack to the left, m.
 */
#define PERCUSS_STEER 3

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/*
 The message of the last failed call on this thread: location, received value, expected value; UTF-8, "" without a
 failure. Valid until the next failed call on this thread.
 */
const char *percuss_error_message(void);

/*
 The version of the library, such as "0.1.0". The header's version is PERCUSS_VERSION. While the first number is 0,
 the second number changes with every change that requires programs to be recompiled.
 */
const char *percuss_version(void);

/*
 Reads a file of a model: URDF (closed loops and couplings included), MJCF or SDFormat, recognised by its content. path: UTF-8. Free
 the model with percuss_model_free.

 Errors: PERCUSS_ERROR_LOAD, with every error of the file in the message.

 Pointers:
 path ends with a zero byte; model is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_model_load_file(const char *path,
                                       struct percuss_model **model);

/*
 Reads a model from memory, as percuss_model_load_file: length bytes of UTF-8 without a terminating zero byte. name replaces the file name in
 messages.

 Errors: as percuss_model_load_file; PERCUSS_ERROR_TEXT.

 Pointers:
 name ends with a zero byte; bytes has length bytes; model is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_model_load_memory(const char *name,
                                         const char *bytes,
                                         size_t length,
                                         struct percuss_model **model);

/*
 Frees a model and sets the handle to null; a null handle is ignored. Objects made from the model stay valid.

 Pointers:
 model is null or points to a handle that no other call uses.
 */
percuss_status percuss_model_free(struct percuss_model **model);

/*
 Numbers of links, joints, positions of all joints, and velocities of all joints. Each pointer may be null.

 Pointers:
 Every pointer is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_model_counts(const struct percuss_model *model,
                                    size_t *links,
                                    size_t *joints,
                                    size_t *positions,
                                    size_t *velocities);

/*
 The name of link number index, from 0. Valid as long as the model; null if the call fails.

 Pointers:
 name is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_model_link_name(const struct percuss_model *model, size_t index, const char **name);

/*
 The number of the link of this name. Errors: PERCUSS_ERROR_NAME, with the most similar name.

 Pointers:
 name ends with a zero byte; index is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_model_find_link(const struct percuss_model *model, const char *name, size_t *index);

/*
 The number of the joint of this name. Errors: PERCUSS_ERROR_NAME, with the most similar name.

 Pointers:
 name ends with a zero byte; index is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_model_find_joint(const struct percuss_model *model, const char *name, size_t *index);

/*
 Joint number index, from 0.

 Pointers:
 joint is null or points to storage for a percuss_joint.
 */
PERCUSS_NODISCARD percuss_status percuss_model_joint(const struct percuss_model *model, size_t index, struct percuss_joint *joint);

/*
 Number of named poses of the file: keyframes of MJCF.

 Pointers:
 count is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_model_pose_count(const struct percuss_model *model, size_t *count);

/*
 The name of named pose number index, from 0. Valid as long as the model; null if the call fails.

 Pointers:
 name is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_model_pose_name(const struct percuss_model *model, size_t index, const char **name);

/*
 Positions of all joints, concatenated in joint order, at the named pose of this name: for percuss_configuration_set_positions,
 which closes the loops from there. count: the positions of percuss_model_counts; those of mimics are 0.

 Errors: PERCUSS_ERROR_NAME, with the names of the model's poses; PERCUSS_ERROR_LENGTH.

 Pointers:
 name ends with a zero byte; positions has space for count numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_model_pose_positions(const struct percuss_model *model,
                                            const char *name,
                                            double *positions,
                                            size_t count);

/*
 Positions of all joints, concatenated in joint order, for the positions qpos of MuJoCo of a model that was read from its MJCF:
 minus ref for a hinge or a slide, relative to the drawing for a free joint. qpos_count: nq of MuJoCo; count: the positions of
 percuss_model_counts; those of mimics are as drawn, and not read. Allocates nothing.

 Errors: PERCUSS_ERROR_ARGUMENT: a model of another format, a free body whose frame MuJoCo moves (align), a number that is not finite, a
 quaternion 0; PERCUSS_ERROR_LENGTH.

 Pointers:
 qpos has qpos_count numbers; positions has space for count numbers; they do not overlap.
 */
PERCUSS_NODISCARD percuss_status percuss_model_positions_of_qpos(const struct percuss_model *model,
                                               const double *qpos,
                                               size_t qpos_count,
                                               double *positions,
                                               size_t count);

/*
 Number of notes and warnings about the file.

 Pointers:
 count is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_model_diagnostic_count(const struct percuss_model *model, size_t *count);

/*
 Note or warning number index, from 0, in the order of the file.

 Pointers:
 diagnostic is null or points to storage for a percuss_diagnostic.
 */
PERCUSS_NODISCARD percuss_status percuss_model_diagnostic(const struct percuss_model *model,
                                        size_t index,
                                        struct percuss_diagnostic *diagnostic);

/*
 A hinge at the parent's origin about the x-axis, without name, links, limits and armature.

 Pointers:
 description is null or points to storage for a percuss_joint_description.
 */
PERCUSS_NODISCARD percuss_status percuss_joint_description_init(struct percuss_joint_description *description);

/*
 A hinge about the x-axis between the origins of two links, without names.

 Pointers:
 description is null or points to storage for a percuss_closure_description.
 */
PERCUSS_NODISCARD percuss_status percuss_closure_description_init(struct percuss_closure_description *description);

/*
 A model without links. Free it with percuss_builder_free.

 Pointers:
 name ends with a zero byte; builder is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_builder_new(const char *name, struct percuss_builder **builder);

/*
 Frees a builder and sets the handle to null; a null handle is ignored.

 Pointers:
 builder is null or points to a handle that no other call uses.
 */
percuss_status percuss_builder_free(struct percuss_builder **builder);

/*
 Adds a link. mass: kg; com: its centre of mass in the link's frame, 3 numbers, m; inertia: about the centre of mass in the link's axes,
 xx, xy, xz, yy, yz, zz, kg·m². If com is null, the centre of mass is at the origin; if inertia is null, all moments are 0. A link with
 mass 0 and null inertia is massless.

 Pointers:
 builder is a handle; name ends with a zero byte; com is null or has 3 numbers, inertia is null or has 6.
 */
PERCUSS_NODISCARD percuss_status percuss_builder_link(struct percuss_builder *builder,
                                    const char *name,
                                    double mass,
                                    const double *com,
                                    const double *inertia);

/*
 Adds a joint between two links. The links may be added later.

 Errors: PERCUSS_ERROR_ARGUMENT: an unknown kind, a quaternion that is not of unit length, one limit without the other, an armature_count
 outside 0 to 6.

 Pointers:
 builder is a handle; description is null or points to a description.
 */
PERCUSS_NODISCARD percuss_status percuss_builder_joint(struct percuss_builder *builder,
                                     const struct percuss_joint_description *description);

/*
 Adds a closure between two links.

 Errors: PERCUSS_ERROR_ARGUMENT: an unknown kind, a quaternion that is not of unit length.

 Pointers:
 builder is a handle; description is null or points to a description.
 */
PERCUSS_NODISCARD percuss_status percuss_builder_closure(struct percuss_builder *builder,
                                       const struct percuss_closure_description *description);

/*
 The model of a builder, which stays usable. Free it with percuss_model_free.

 Errors: PERCUSS_ERROR_LOAD; the message has every error of the description.

 Pointers:
 builder is a handle; model is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_builder_model(struct percuss_builder *builder, struct percuss_model **model);

/*
 Fixed base, every joint free, armatures as declared in the file. Free the conditions with percuss_conditions_free.

 Pointers:
 conditions is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_conditions_new(struct percuss_conditions **conditions);

/*
 Frees conditions and sets the handle to null; a null handle is ignored.

 Pointers:
 conditions is null or points to a handle that no other call uses.
 */
percuss_status percuss_conditions_free(struct percuss_conditions **conditions);

/*
 Sets the mobility of the root link: PERCUSS_BASE_FIXED (the default) or PERCUSS_BASE_FLOATING.

 Pointers:
 conditions is null or a handle.
 */
PERCUSS_NODISCARD percuss_status percuss_conditions_base(struct percuss_conditions *conditions, int32_t base);

/*
 Locks a joint at its position: its velocities are zero. percuss_system_new checks the name of the joint.

 Pointers:
 joint ends with a zero byte.
 */
PERCUSS_NODISCARD percuss_status percuss_conditions_lock(struct percuss_conditions *conditions, const char *joint);

/*
 Replaces a joint's armature (the rotor's inertia at the joint, kg·m² or kg): one value for all velocities of the
 joint, or one value per velocity. percuss_system_new checks the values.

 Pointers:
 joint ends with a zero byte; values has count numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_conditions_armature(struct percuss_conditions *conditions,
                                           const char *joint,
                                           const double *values,
                                           size_t count);

/*
 Holds a point (3 numbers, m, link's frame) of a link to the ground: along a normal (3 numbers, root link's axes), or
 in all directions if normal is null. Constrains velocities only. percuss_system_new checks the values.

 Pointers:
 link ends with a zero byte; point has 3 numbers; normal is null or has 3.
 */
PERCUSS_NODISCARD percuss_status percuss_conditions_hold(struct percuss_conditions *conditions,
                                       const char *link,
                                       const double *point,
                                       const double *normal);

/*
 Every joint at zero (quaternions at 1, 0, 0, 0), the root link at the world's origin. Free it with percuss_configuration_free.

 Pointers:
 model is a handle; configuration is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_configuration_new(const struct percuss_model *model,
                                         struct percuss_configuration **configuration);

/*
 Frees a configuration and sets the handle to null; a null handle is ignored.

 Pointers:
 configuration is null or points to a handle that no other call uses.
 */
percuss_status percuss_configuration_free(struct percuss_configuration **configuration);

/*
 Resets every joint to zero and removes all settings and guesses.

 Pointers:
 configuration is null or a handle.
 */
PERCUSS_NODISCARD percuss_status percuss_configuration_reset(struct percuss_configuration *configuration);

/*
 Sets a driving joint to count values (layouts of percuss_joint_kind). Other joints of the loops follow.

 Errors: PERCUSS_ERROR_CONDITIONS: unknown joint, repeated setting, a mimic, a wrong number of values, an invalid
 value.

 Pointers:
 joint ends with a zero byte; values has count numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_configuration_set(struct percuss_configuration *configuration,
                                         const char *joint,
                                         const double *values,
                                         size_t count);

/*
 Sets the initial position in the search for a dependent joint of a loop, which selects the assembly mode.

 Errors: as percuss_configuration_set.

 Pointers:
 As percuss_configuration_set.
 */
PERCUSS_NODISCARD percuss_status percuss_configuration_guess(struct percuss_configuration *configuration,
                                           const char *joint,
                                           const double *values,
                                           size_t count);

/*
 Sets the whole configuration: the positions of all joints, concatenated in joint order; positions of mimics are not
 read. Loops are closed from there. Earlier settings are dropped.

 Errors: PERCUSS_ERROR_CONDITIONS.

 Pointers:
 positions has count numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_configuration_set_positions(struct percuss_configuration *configuration,
                                                   const double *positions,
                                                   size_t count);

/*
 Sets the pose of the root link in the world: its origin (3 numbers, m) and its orientation (4 numbers, a unit
 quaternion w, x, y, z: a norm within 0.01 of 1, which is normalised).

 Errors: PERCUSS_ERROR_ARGUMENT: a number that is not finite, another norm.

 Pointers:
 position has 3 numbers, quaternion 4.
 */
PERCUSS_NODISCARD percuss_status percuss_configuration_set_base(struct percuss_configuration *configuration,
                                              const double *position,
                                              const double *quaternion);

/*
 Accepts a pose on another assembly mode, beyond the reach of the branch of the first closed pose. Such a pose has
 PERCUSS_REMARK_OTHER_ASSEMBLY; without this setting, the result is PERCUSS_ERROR_ASSEMBLY. A guess also selects a
 mode.

 Pointers:
 configuration is null or a handle.
 */
PERCUSS_NODISCARD percuss_status percuss_configuration_allow_other_assembly(struct percuss_configuration *configuration);

/*
 Compiles a mechanism with the conditions of an analysis; null conditions: fixed base, every joint free. The model
 and the conditions may be freed afterwards. Free the system with percuss_system_free.

 Errors: PERCUSS_ERROR_CONDITIONS.

 Pointers:
 model is a handle; conditions is null or a handle; system is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_system_new(const struct percuss_model *model,
                                  const struct percuss_conditions *conditions,
                                  struct percuss_system **system);

/*
 Frees a system and sets the handle to null; a null handle is ignored. Objects made from the system stay valid.

 Pointers:
 system is null or points to a handle that no other call uses.
 */
percuss_status percuss_system_free(struct percuss_system **system);

/*
 Number of coordinates: independent velocities of the tree, without locked joints and mimics; a floating base adds
 six. Order: the base first, then the joints from the root.

 Pointers:
 coordinates is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_system_coordinates(const struct percuss_system *system, size_t *coordinates);

/*
 Assembles the loops: from all joints at 0 if configuration is null, else from its guesses. A mechanism without loops
 has one assembly. Free it with percuss_assembly_free.

 Errors: PERCUSS_ERROR_ASSEMBLY, with the name of the open loop.

 Pointers:
 system is a handle; configuration is null or a handle; assembly is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_assembly_new(const struct percuss_system *system,
                                    const struct percuss_configuration *configuration,
                                    struct percuss_assembly **assembly);

/*
 Frees an assembly and sets the handle to null; a null handle is ignored. Objects made from the assembly stay valid.

 Pointers:
 assembly is null or points to a handle that no other call uses.
 */
percuss_status percuss_assembly_free(struct percuss_assembly **assembly);

/*
 Degrees of freedom at a generic pose (a floating base counts 6), and number of redundant rows of A at that pose.
 Each pointer may be null.

 Pointers:
 Every pointer is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_assembly_mobility(const struct percuss_assembly *assembly,
                                         size_t *degrees_of_freedom,
                                         size_t *redundant_constraints);

/*
 Contact with the ground at the origin of a link. The caller must set the link (initially PERCUSS_NO_LINK) and the
 normal (initially 0, 0, 0, in the link's frame).

 Pointers:
 contact is null or points to storage for a percuss_contact.
 */
PERCUSS_NODISCARD percuss_status percuss_contact_init(struct percuss_contact *contact);

/*
 The named contact of a model: a stop, the seat of a spring or damper, a contact patch. gap (may be null): the gap with all
 joints at 0, m; 0 if the parts always touch. Errors: PERCUSS_ERROR_NAME, with the most similar name.

 Pointers:
 name ends with a zero byte; contact is null or points to storage for a percuss_contact, gap to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_model_find_contact(const struct percuss_model *model,
                                          const char *name,
                                          struct percuss_contact *contact,
                                          double *gap);

/*
 The pose at a configuration: set joints drive, other joints of the loops follow. The pose belongs to the assembly
 found from all joints at 0 or, if no loop closes from there, to the assembly found from the configuration's guesses.
 Free it with percuss_pose_free.

 Errors: PERCUSS_ERROR_ASSEMBLY: loops that do not close, drivers that cannot reach their positions, a dependent
 joint that was set.

 Pointers:
 system and configuration are handles; pose is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_new(const struct percuss_system *system,
                                const struct percuss_configuration *configuration,
                                struct percuss_pose **pose);

/*
 Like percuss_pose_new, for a given assembly.

 Pointers:
 assembly and configuration are handles; pose is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_assembly_pose(const struct percuss_assembly *assembly,
                                     const struct percuss_configuration *configuration,
                                     struct percuss_pose **pose);

/*
 The pose at a configuration on the branch of another pose of the same assembly, followed from that pose: for steps
 of a motion.

 Pointers:
 from and configuration are handles; pose is null or points to storage for a pointer, other than from.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_follow(const struct percuss_pose *from,
                                   const struct percuss_configuration *configuration,
                                   struct percuss_pose **pose);

/*
 Frees a pose and sets the handle to null; a null handle is ignored.

 Pointers:
 pose is null or points to a handle that no other call uses.
 */
percuss_status percuss_pose_free(struct percuss_pose **pose);

/*
 Number of notes and warnings of percuss_pose_touch about the path to the touch, the pose and the contact, as in the report of percuss_ask
 with "contact": {"at": STOP}; 0 for a pose of another call.

 Pointers:
 count is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_diagnostic_count(const struct percuss_pose *pose,
                                             size_t *count);

/*
 Note or warning number index of a pose, from 0. Its texts are valid as long as the pose; its path is empty.

 Pointers:
 diagnostic is null or points to storage for a percuss_diagnostic.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_diagnostic(const struct percuss_pose *pose,
                                       size_t index,
                                       struct percuss_diagnostic *diagnostic);

/*
 The positions of all joints, concatenated in joint order, mimics included: count is the positions of
 percuss_model_counts.

 Pointers:
 positions has space for count numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_positions(const struct percuss_pose *pose, double *positions, size_t count);

/*
 m̄ of a contact, with its error. route: normally PERCUSS_ROUTE_AUTO.

 Errors: PERCUSS_ERROR_CONTACT: an invalid contact, or a contact that the route cannot solve.

 Pointers:
 pose is a handle; contact is null or points to a contact; mass is null or points to storage for a percuss_mass.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_effective_mass(const struct percuss_pose *pose,
                                           const struct percuss_contact *contact,
                                           percuss_route route,
                                           struct percuss_mass *mass);

/*
 The full response to a contact, with v* and the contributions. Free it with percuss_response_free.

 Errors: as percuss_pose_effective_mass.

 Pointers:
 As percuss_pose_effective_mass; response is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_respond(const struct percuss_pose *pose,
                                    const struct percuss_contact *contact,
                                    percuss_route route,
                                    struct percuss_response **response);

/*
 M, the mass matrix over the coordinates, n×n (kg, kg·m, kg·m²), written to an array of length numbers.

 Pointers:
 values has space for length numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_mass_matrix(const struct percuss_pose *pose,
                                        double *values,
                                        size_t length,
                                        percuss_layout layout,
                                        size_t leading_dimension);

/*
 Number of rows of A, redundant rows included.

 Pointers:
 rows is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_constraint_rows(const struct percuss_pose *pose, size_t *rows);

/*
 A, the Jacobian of all constraints over the coordinates, rows×n, written to an array of length numbers; each group
 of loops is scaled to entries of at most 1.

 Pointers:
 values has space for length numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_constraint_matrix(const struct percuss_pose *pose,
                                              double *values,
                                              size_t length,
                                              percuss_layout layout,
                                              size_t leading_dimension);

/*
 j, the closing speed of a contact at unit rates of the coordinates, 1×n (m, 1): count is n.

 Pointers:
 contact is null or points to a contact; values has space for count numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_contact_row(const struct percuss_pose *pose,
                                        const struct percuss_contact *contact,
                                        double *values,
                                        size_t count);

/*
 The pose at which a stop touches, and its contact, as the command `percuss mass --at STOP`. stop: the name of a contact of the model,
 or the stop of a joint, JOINT:lower or JOINT:upper. The mechanism moves from the pose of the configuration until the gap is closed; joints
 that are set keep their positions, and if no other joint moves the stop, the gap stays open (PERCUSS_REMARK_OPEN_GAP). Free the
 pose with percuss_pose_free. Findings about the path to the touch, such as a stop that touches while the wheel moves the wrong way, about the
 pose and about the contact: percuss_pose_diagnostic.

 Errors: PERCUSS_ERROR_NAME: an unknown stop. PERCUSS_ERROR_ASSEMBLY: a stop that is out of reach, with the smallest gap; loops that do not close.

 Pointers:
 system and configuration are handles; stop ends with a zero byte; pose is null or points to storage for a pointer; contact is null or
 points to storage for a percuss_contact.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_touch(const struct percuss_system *system,
                                  const struct percuss_configuration *configuration,
                                  const char *stop,
                                  struct percuss_pose **pose,
                                  struct percuss_contact *contact);

/*
 Frees a response and sets the handle to null; a null handle is ignored.

 Pointers:
 response is null or points to a handle that no other call uses.
 */
percuss_status percuss_response_free(struct percuss_response **response);

/*
 m̄ and its error.

 Pointers:
 mass is null or points to storage for a percuss_mass.
 */
PERCUSS_NODISCARD percuss_status percuss_response_mass(const struct percuss_response *response, struct percuss_mass *mass);

/*
 m̄ and its error with a free body of mass other (kg) as the other side: 1/m̄ = 1/m̄₁ + 1/m₂.

 Pointers:
 mass is null or points to storage for a percuss_mass.
 */
PERCUSS_NODISCARD percuss_status percuss_response_against_mass(const struct percuss_response *response,
                                             double other,
                                             struct percuss_mass *mass);

/*
 v*: the velocities of all joints at unit closing speed (1/m·rad, 1), concatenated in joint order; count is the
 velocities of percuss_model_counts. Also defined for a contact that is not finite, if a motion is known; else zeros.

 Pointers:
 velocities has space for count numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_response_velocities(const struct percuss_response *response, double *velocities, size_t count);

/*
 v* of a floating root link: 3 angular and 3 linear numbers, in its axes at its origin; zeros for a fixed root link.

 Pointers:
 twist has space for 6 numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_response_base_velocity(const struct percuss_response *response, double *twist);

/*
 The contribution of each link to m̄, in link order (link_count numbers), and of the rotor of each joint (joint_count
 numbers): their sum is 1. Errors: PERCUSS_ERROR_CONTACT if m̄ is not finite.

 Pointers:
 links has space for link_count numbers, rotors for joint_count; rotors may be null.
 */
PERCUSS_NODISCARD percuss_status percuss_response_contributions(const struct percuss_response *response,
                                              double *links,
                                              size_t link_count,
                                              double *rotors,
                                              size_t joint_count);

/*
 Rigid impact without friction at a contact, with the closing speed (m/s) and the coefficient of restitution (0 to 1).

 before (count numbers, or null): the velocities of all joints before the impact, concatenated in joint order, as for
 percuss_response_velocities; they must have this closing speed, and the base is then at rest. null: the motion of least energy with
 this closing speed, v* times the speed. after (count numbers, or null): the velocities after the impact.
 reactions (6 joint_count numbers, or null): for each joint the impulse of the parent on the child, N·s, along two transverse
 directions and the axis of the joint, then its moment about the child's origin, N·m·s; NaN for a component that redundant loops leave
 open.

 Errors: PERCUSS_ERROR_ARGUMENT: speed or restitution out of range, or velocities in before with another closing speed.
 PERCUSS_ERROR_CONTACT: an invalid contact, or a contact without finite m̄.

 Pointers:
 pose is a handle; contact and impact are null or point to their types; before, after and reactions are null or have space for the
 given counts.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_impact(const struct percuss_pose *pose,
                                   const struct percuss_contact *contact,
                                   double speed,
                                   double restitution,
                                   const double *before,
                                   double *after,
                                   size_t count,
                                   double *reactions,
                                   size_t reaction_count,
                                   struct percuss_rigid_impact *impact);

/*
 Workspace for many poses of an assembly, initially at its first closed pose. Free it with percuss_workspace_free.

 Pointers:
 assembly is a handle; workspace is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_workspace_new(const struct percuss_assembly *assembly, struct percuss_workspace **workspace);

/*
 Frees a workspace and sets the handle to null; a null handle is ignored.

 Pointers:
 workspace is null or points to a handle that no other call uses.
 */
percuss_status percuss_workspace_free(struct percuss_workspace **workspace);

/*
 m̄ of a contact at the positions of all joints (concatenated in joint order; unit quaternions; positions of mimics
 are not read): count numbers, the positions of percuss_model_counts. Loops must be closed at these positions, to a
 millionth of their size; positions of a pose of the same assembly satisfy this.

 effective_mass: kg; NaN unless the outcome is PERCUSS_FINITE. remarks: null, or storage for PERCUSS_REMARK_… added
 together. No error bound is computed: use percuss_pose_effective_mass. Allocates nothing after the first call,
 unless the recursion is not accurate enough. For normals in the world, the root link is at the pose of
 percuss_workspace_set_base, else at the world's origin.

 Errors: PERCUSS_ERROR_NULL, PERCUSS_ERROR_LENGTH; PERCUSS_ERROR_ARGUMENT: a relevant position is not finite, a
 quaternion is not of unit length; PERCUSS_ERROR_ASSEMBLY: a loop is open, with the gap and the tolerance;
 PERCUSS_ERROR_CONTACT; PERCUSS_ERROR_OVERLAP; PERCUSS_ERROR_BUSY if another thread uses the workspace.

 Pointers:
 workspace is a handle; positions is null or has count numbers; contact is null or points to a contact; the other
 pointers are null or point to storage.
 */
PERCUSS_NODISCARD percuss_status percuss_workspace_effective_mass(struct percuss_workspace *workspace,
                                                const double *positions,
                                                size_t count,
                                                const struct percuss_contact *contact,
                                                percuss_outcome *outcome,
                                                double *effective_mass,
                                                uint32_t *remarks);

/*
 m̄ of another contact at the last positions of the workspace; at its first closed pose if no positions were given.

 Errors: as percuss_workspace_effective_mass.

 Pointers:
 As percuss_workspace_effective_mass.
 */
PERCUSS_NODISCARD percuss_status percuss_workspace_effective_mass_again(struct percuss_workspace *workspace,
                                                      const struct percuss_contact *contact,
                                                      percuss_outcome *outcome,
                                                      double *effective_mass,
                                                      uint32_t *remarks);

/*
 m̄ of a contact at the last positions of the workspace, its error, findings, and v*: the velocities of all joints at unit closing
 speed (1/m·rad, 1), concatenated in joint order; velocity_count is the velocities of percuss_model_counts. positions: count
 numbers, as percuss_workspace_effective_mass; null with count 0: the last positions. Allocates nothing after the first call,
 unless the recursion is not accurate enough. v* is zero unless m̄ is finite.

 Errors: as percuss_workspace_effective_mass.

 Pointers:
 workspace is a handle; positions is null or has count numbers; contact is null or points to a contact; response is null or points
 to storage; velocities has space for velocity_count numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_workspace_respond(struct percuss_workspace *workspace,
                                         const double *positions,
                                         size_t count,
                                         const struct percuss_contact *contact,
                                         struct percuss_workspace_response *response,
                                         double *velocities,
                                         size_t velocity_count);

/*
 Sets the pose of the root link in the world, as percuss_configuration_set_base: for normals that are given in the
 world.

 Errors: PERCUSS_ERROR_ARGUMENT.

 Pointers:
 workspace is a handle; position has 3 numbers, quaternion 4.
 */
PERCUSS_NODISCARD percuss_status percuss_workspace_set_base(struct percuss_workspace *workspace,
                                          const double *position,
                                          const double *quaternion);

/*
 Prepares m̄ of one contact at many configurations of an assembly. threads: number of threads (at most 1024), which
 belong to the batch; 1: the calling thread alone; 0: one per processor of the machine. For normals in the world, the
 root link is at the world's origin; percuss_workspace_batch uses another base. Free it with percuss_batch_free.

 Errors: PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_ARGUMENT.

 Pointers:
 assembly is a handle; contact is null or points to a contact; batch is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_batch_new(const struct percuss_assembly *assembly,
                                 const struct percuss_contact *contact,
                                 size_t threads,
                                 struct percuss_batch **batch);

/*
 Like percuss_batch_new, with the assembly and the base of a workspace (percuss_workspace_set_base), for normals in
 the world. The workspace may be used or freed afterwards.

 Errors: as percuss_batch_new; PERCUSS_ERROR_BUSY.

 Pointers:
 workspace is a handle; contact is null or points to a contact; batch is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_workspace_batch(struct percuss_workspace *workspace,
                                       const struct percuss_contact *contact,
                                       size_t threads,
                                       struct percuss_batch **batch);

/*
 Ends the threads of a batch, frees it and sets the handle to null; a null handle is ignored.

 Pointers:
 batch is null or points to a handle that no other call uses.
 */
percuss_status percuss_batch_free(struct percuss_batch **batch);

/*
 m̄ at count configurations. A configuration holds the positions of all joints (p numbers, the positions of
 percuss_model_counts) with closed loops.

 positions: length numbers; PERCUSS_ROW_MAJOR: configuration c begins at c · stride, stride ≥ p;
 PERCUSS_COLUMN_MAJOR: position q of configuration c is at q · stride + c, stride ≥ count: the fastest layout.
 outcomes and effective_masses: count values each, as for percuss_workspace_effective_mass; PERCUSS_NO_ANSWER for a
 row without an answer, PERCUSS_MASSLESS_TO_ROUNDING if rounding may hide a mass. errors: null, or count numbers of
 output: the error by rounding, kg; NaN if not computed; for a contact that is massless to rounding only, its largest
 possible m̄. remarks: null, or count numbers of output: PERCUSS_REMARK_… added together, with the reason for a row
 without an answer. watch: null, or a function that is called periodically with user, in the default floating-point
 environment. Output arrays must not overlap each other or the positions.

 Errors: PERCUSS_ERROR_LENGTH; PERCUSS_ERROR_OVERLAP; PERCUSS_ERROR_STOPPED: finished results are kept, the other
 rows are PERCUSS_NO_ANSWER. PERCUSS_ERROR_HANDLE: the process was forked after percuss_batch_new, and the threads
 belong to the parent process.

 Pointers:
 batch is a handle; every array has the stated number of values; watch may be called with user.
 */
PERCUSS_NODISCARD percuss_status percuss_batch_run(const struct percuss_batch *batch,
                                 const double *positions,
                                 size_t length,
                                 percuss_layout layout,
                                 size_t stride,
                                 size_t count,
                                 percuss_outcome *outcomes,
                                 double *effective_masses,
                                 double *errors,
                                 uint32_t *remarks,
                                 percuss_watch watch,
                                 void *user);

/*
 Frame of a link in the world: rotation (9 numbers, row by row) and origin (3 numbers, m).

 Errors: PERCUSS_ERROR_NAME: no link of this index.

 Pointers:
 pose is a handle; rotation has space for 9 numbers, origin for 3.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_link_frame(const struct percuss_pose *pose, size_t link, double *rotation, double *origin);

/*
 Gradient g of m̄ by the velocities of all joints, in joint order: dm̄/dt = g · v (kg/rad, kg/m) for every admissible motion v; count
 is the velocities of percuss_model_counts. outcome and effective_mass: as percuss_workspace_effective_mass; g is NaN unless the
 outcome is PERCUSS_FINITE and the error of m̄ at most 1e-6 m̄.

 Errors: as percuss_pose_effective_mass.

 Pointers:
 pose is a handle; contact is null or points to a contact; gradient has space for count numbers; outcome and effective_mass are
 null or point to storage.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_gradient(const struct percuss_pose *pose,
                                     const struct percuss_contact *contact,
                                     double *gradient,
                                     size_t count,
                                     percuss_outcome *outcome,
                                     double *effective_mass);

/*
 Φ = J M⁻¹ Jᵀ of the contact link at the contact point, under the constraints: 36 numbers, 6×6 row by row, in root axes, angular part
 first; 1/m̄ = nᵀΦn for contacts with the ground, n = (0, normal). Its inverse is the operational space inertia.

 Errors: as percuss_pose_effective_mass; PERCUSS_ERROR_CONTACT if a motion without mass responds.

 Pointers:
 pose is a handle; contact is null or points to a contact; values has space for 36 numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_inverse_inertia(const struct percuss_pose *pose,
                                            const struct percuss_contact *contact,
                                            double *values);

/*
 m̄ at count configurations, with a contact point and normal for each, its gradient and Φ.

 positions, length, layout, stride, count, outcomes, effective_masses: as percuss_batch_run. points (m, in the frame of the contact
 link) and normals (of any length, in the frame of the contact's normal): 3 numbers for each configuration, or 3 for all, with
 point_numbers and normal_numbers numbers; both null: those of the contact of the batch. errors: count numbers. gradients: null,
 or count × n numbers, row by row, n the velocities of percuss_model_counts, as percuss_pose_gradient. inverse_inertias: null, or
 count × 36 numbers, as percuss_pose_inverse_inertia. Without a result the numbers are NaN.

 Errors: as percuss_batch_run; PERCUSS_ERROR_CONTACT: an invalid point or normal, with the number of its configuration.

 Pointers:
 batch is a handle; every array has the stated number of values, or is null where this is permitted.
 */
PERCUSS_NODISCARD percuss_status percuss_batch_derivatives(const struct percuss_batch *batch,
                                         const double *positions,
                                         size_t length,
                                         percuss_layout layout,
                                         size_t stride,
                                         size_t count,
                                         const double *points,
                                         size_t point_numbers,
                                         const double *normals,
                                         size_t normal_numbers,
                                         percuss_outcome *outcomes,
                                         double *effective_masses,
                                         double *errors,
                                         double *gradients,
                                         double *inverse_inertias);

/*
 State of a pose: degrees of freedom, rank, findings, closing of the loops.

 Pointers:
 pose is a handle; state is null or points to storage for a percuss_pose_state.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_describe(const struct percuss_pose *pose, struct percuss_pose_state *state);

/*
 m̄ of count contacts of a link at one pose, by the inverse operational inertia of the link: some nanoseconds per contact.

 against: the other side, a link or PERCUSS_GROUND. points (m) and normals (out of the link, of any length): 3 × count numbers each, one
 contact after another, in the frame of the link. outcomes and effective_masses (kg; NaN unless finite): count values each. errors: null,
 or count numbers, the error of m̄, kg; NaN unless finite.

 Errors: PERCUSS_ERROR_NAME: no link of this number; PERCUSS_ERROR_ARGUMENT: a number that is not finite, a zero normal;
 PERCUSS_ERROR_CONTACT: link and against are the same link; PERCUSS_ERROR_LENGTH: count above SIZE_MAX / 3; PERCUSS_ERROR_OVERLAP.

 Pointers:
 pose is a handle; every array has the stated number of values, or is null where this is permitted.
 */
PERCUSS_NODISCARD percuss_status percuss_pose_contact_map(const struct percuss_pose *pose,
                                        size_t link,
                                        size_t against,
                                        const double *points,
                                        const double *normals,
                                        size_t count,
                                        percuss_outcome *outcomes,
                                        double *effective_masses,
                                        double *errors);

/*
 Path of driving joints (indices of percuss_model_find_joint, of one position each) from a pose, for one contact. All other drivers
 keep their positions. Free it with percuss_path_free.

 Errors: PERCUSS_ERROR_ASSEMBLY if the mechanism has no such path: no loops, more degrees of freedom than the kernel has, redundant
 rows, a singular pose, or a joint that is no driver; percuss_pose_follow then closes the loops. PERCUSS_ERROR_CONTACT,
 PERCUSS_ERROR_NAME.

 Pointers:
 pose is a handle; contact is null or points to a contact; joints has joint_count numbers; path is null or points to storage for a
 pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_path_new(const struct percuss_pose *pose,
                                const struct percuss_contact *contact,
                                const size_t *joints,
                                size_t joint_count,
                                struct percuss_path **path);

/*
 Frees a path and sets the handle to null; a null handle is ignored.

 Pointers:
 path is null or points to a handle that no other call uses.
 */
percuss_status percuss_path_free(struct percuss_path **path);

/*
 Follows rows of the path: values has count rows of one number per joint of the path. Newton's method closes the loops of each row
 from the row before. done: number of rows that were completed; the path stops before a row of which the branch is in doubt, and
 percuss_path_restart continues it. Allocates nothing after a call with as many rows.

 positions: count × p numbers, the positions of all joints, row by row, for percuss_workspace_respond and batches.
 effective_masses, errors: null, or count numbers: m̄ and its error, kg; NaN where m̄ is uncertain, for percuss_workspace_respond at
 these positions. remarks: null, or count numbers: PERCUSS_REMARK_… added together. Rows that were not completed are not written.

 Errors: PERCUSS_ERROR_LENGTH, PERCUSS_ERROR_OVERLAP, PERCUSS_ERROR_BUSY.

 Pointers:
 path is a handle; every array has the stated number of values; done is null or points to storage.
 */
PERCUSS_NODISCARD percuss_status percuss_path_follow(struct percuss_path *path,
                                   const double *values,
                                   size_t length,
                                   size_t count,
                                   double *positions,
                                   size_t position_numbers,
                                   double *effective_masses,
                                   double *errors,
                                   uint32_t *remarks,
                                   size_t *done);

/*
 Moves a path to another pose of the same assembly, for example that of percuss_pose_follow at the row before which the path stopped.

 Errors: PERCUSS_ERROR_ASSEMBLY if the path cannot continue there; the path stays as it is.

 Pointers:
 path and pose are handles.
 */
PERCUSS_NODISCARD percuss_status percuss_path_restart(struct percuss_path *path,
                                    const struct percuss_pose *pose);

/*
 Number of laws: a law has a number from 0 to this count − 1.
 */
size_t percuss_law_count(void);

/*
 The name of a law; valid until the program ends.

 Pointers:
 name is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_law_name(percuss_law law, const char **name);

/*
 The law of this name or alias, upper and lower case alike. Errors: PERCUSS_ERROR_NAME, with the most similar name.

 Pointers:
 name ends with a zero byte; law is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_law_find(const char *name, percuss_law *law);

/*
 The damper of a law for the restitution e on this spring, at the approach speed in m/s; speed 0 means unknown
 (Kelvin–Voigt needs no speed). separation is used by Kelvin–Voigt only.

 Errors: PERCUSS_ERROR_LAW: out of range, missing speed, an e that the law cannot reach.

 Pointers:
 spring is null or points to one; damper is null or points to storage for one.
 */
PERCUSS_NODISCARD percuss_status percuss_law_damper(percuss_law law,
                                  const struct percuss_spring *spring,
                                  double restitution,
                                  double speed,
                                  percuss_separation separation,
                                  struct percuss_damper *damper);

/*
 The restitution of a damper on this spring at this approach speed, m/s. Exact for the force law.

 Errors: PERCUSS_ERROR_LAW.

 Pointers:
 spring and damper are null or point to one; restitution is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_damper_restitution(const struct percuss_damper *damper,
                                          const struct percuss_spring *spring,
                                          double speed,
                                          double *restitution);

/*
 Characteristics of the impact on this spring at this approach speed, m/s.

 Errors: PERCUSS_ERROR_LAW.

 Pointers:
 spring and damper are null or point to one; impact is null or points to storage for one.
 */
PERCUSS_NODISCARD percuss_status percuss_damper_impact(const struct percuss_damper *damper,
                                     const struct percuss_spring *spring,
                                     double speed,
                                     struct percuss_impact *impact);

/*
 Reads a suspension: a sheet (TOML), a table of hardpoints (CSV) or a file of Chrono::Vehicle (JSON), as the command
 percuss does. path: UTF-8. Free it with percuss_suspension_free.

 Errors: PERCUSS_ERROR_LOAD, with every error of the file in the message.

 Pointers:
 path ends with a zero byte; suspension is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_suspension_load_file(const char *path, struct percuss_suspension **suspension);

/*
 Reads a suspension from memory: length bytes of UTF-8 without a terminating zero byte. name replaces the file name in
 messages; its ending (.toml, .csv, .json) determines the format, and its folder is that of a table named in a sheet.

 Errors: as percuss_suspension_load_file; PERCUSS_ERROR_TEXT.

 Pointers:
 name ends with a zero byte; bytes has length bytes; suspension is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_suspension_load_memory(const char *name,
                                              const char *bytes,
                                              size_t length,
                                              struct percuss_suspension **suspension);

/*
 Frees a suspension and sets the handle to null; a null handle is ignored. Objects made from it stay valid.

 Pointers:
 suspension is null or points to a handle that no other call uses.
 */
percuss_status percuss_suspension_free(struct percuss_suspension **suspension);

/*
 The mechanism of a suspension, for effective masses at its named contacts (percuss_pose_touch). Its diagnostics are
 those of the sheet. Free the model with percuss_model_free.

 Pointers:
 suspension is a handle; model is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_suspension_model(const struct percuss_suspension *suspension, struct percuss_model **model);

/*
 Sets all travels to 0 and all data of the vehicle to unknown.

 Pointers:
 vehicle is null or points to storage for one.
 */
PERCUSS_NODISCARD percuss_status percuss_vehicle_init(struct percuss_vehicle *vehicle);

/*
 Camber, toe, roll centre, motion ratios, wheel rates and all other quantities of docs/howto/KINEMATICS.md at the given
 values of a variable (m), one row each. A row whose pose cannot be reached has NaN and a problem. vehicle may be
 null. Derivatives of an axle are those of heave; for the variable PERCUSS_ROLL those of roll. Free the table with
 percuss_kinematics_free.

 Errors: PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_LENGTH; PERCUSS_ERROR_ASSEMBLY: a suspension without a wheel or, to be
 steered, without a rack; travels that do not fit.

 Pointers:
 values has count numbers; vehicle is null or points to one; table is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_suspension_kinematics(const struct percuss_suspension *suspension,
                                             percuss_wheel_motion variable,
                                             const double *values,
                                             size_t count,
                                             const struct percuss_vehicle *vehicle,
                                             struct percuss_kinematics **table);

/*
 Frees a table and sets the handle to null; a null handle is ignored.

 Pointers:
 table is null or points to a handle that no other call uses.
 */
percuss_status percuss_kinematics_free(struct percuss_kinematics **table);

/*
 Numbers of rows and columns of a table. Each pointer may be null.

 Pointers:
 Every pointer is null or points to storage for a number.
 */
PERCUSS_NODISCARD percuss_status percuss_kinematics_counts(const struct percuss_kinematics *table, size_t *rows, size_t *columns);

/*
 Column number index, from 0.

 Pointers:
 column is null or points to storage for one.
 */
PERCUSS_NODISCARD percuss_status percuss_kinematics_column(const struct percuss_kinematics *table,
                                         size_t index,
                                         struct percuss_column *column);

/*
 All values, SI units, row by row; NaN where a value is missing. length is rows times columns.

 Pointers:
 values has space for length numbers.
 */
PERCUSS_NODISCARD percuss_status percuss_kinematics_values(const struct percuss_kinematics *table, double *values, size_t length);

/*
 The reason why row number row, from 0, has no pose; null for a row with a pose. Valid as long as the table.

 Pointers:
 problem is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_kinematics_problem(const struct percuss_kinematics *table, size_t row, const char **problem);

/*
 Results of the tables of a request: effective mass, damper and parameters of simulators, impact, extremes, sweep, comparison,
 kinematics, map, safe speed, contents of the model (table check), source code (table generate), the model in another
 format (convert) or with an impact for MuJoCo (export): files as text. request: JSON object with the tables of a study (docs/study.schema.json), without the path of a model and
 without output files; the table "model" may have changes of the model. The keys of the report are the tables: {"mass": …,
 "impact": …}, each with the report of the command in docs/reference/OUTPUTS.md. SI units. Paths in the request are relative to the working directory.
 Free the report with percuss_report_free.

 Errors: PERCUSS_ERROR_ARGUMENT: invalid JSON, an unknown key, or an invalid value; the message contains the key.
 PERCUSS_ERROR_CONTACT: a valid question without a result.

 Pointers:
 model is a handle; request ends with a zero byte; report is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_ask(const struct percuss_model *model,
                           const char *request,
                           struct percuss_report **report);

/*
 The JSON text of a report, UTF-8. Valid as long as the report; null if the call fails.

 Pointers:
 report is a handle; json is null or points to storage for a pointer.
 */
PERCUSS_NODISCARD percuss_status percuss_report_json(const struct percuss_report *report, const char **json);

/*
 Frees a report and sets the handle to null; a null handle is ignored.

 Pointers:
 report is null or points to a handle that no other call uses.
 */
percuss_status percuss_report_free(struct percuss_report **report);

/*
 Sets the default options.

 Pointers:
 options is null or points to storage for a percuss_matrix_options.
 */
PERCUSS_NODISCARD percuss_status percuss_matrix_options_init(struct percuss_matrix_options *options);

/*
 m̄ = min { vᵀMv : Av = 0, jv = 1 } of a system given by its matrices: mass is M, n×n, symmetric, positive
 semi-definite (kg, kg·m, kg·m²); contact_row is j, count = n numbers (m, 1); constraints is A, m×n, or null. M may
 be singular, rows of A may be redundant.

 mass_result: the outcome, m̄ (kg), its error (error and error_rounding), the remarks. velocities: null, or n numbers
 of output: v*, the velocities at unit closing speed. rank: null, or storage for the rank report of A.
 redundant_rows: null, or m bytes of output: 1 for each redundant row of A, else 0. options: null for the defaults.

 Errors: PERCUSS_ERROR_LENGTH: shapes; PERCUSS_ERROR_ARGUMENT: NaN, infinities, options; PERCUSS_ERROR_MATRIX: not
 symmetric, not positive semi-definite, more than 1000 coordinates.

 Pointers:
 Every pointer is null or points to the stated values; the arrays of the matrices have the stated lengths.
 */
PERCUSS_NODISCARD percuss_status percuss_effective_mass(const struct percuss_matrix *mass,
                                      const double *contact_row,
                                      size_t count,
                                      const struct percuss_matrix *constraints,
                                      const struct percuss_matrix_options *options,
                                      struct percuss_mass *mass_result,
                                      double *velocities,
                                      struct percuss_rank *rank,
                                      uint8_t *redundant_rows);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* PERCUSS_H */
