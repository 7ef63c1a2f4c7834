/* percuss: the effective mass of a mechanism at a contact. Made by cbindgen from crates/capi/src; not written by hand. docs/C.md says how it is used. */

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

/* No link: the ground. */
#define PERCUSS_GROUND SIZE_MAX

/* No link is given: the link of a contact before it is set. */
#define PERCUSS_NO_LINK (SIZE_MAX - 1)

/*
 Worth knowing; nothing is wrong.
 */
#define PERCUSS_NOTE 0

/*
 Probably not what was meant; the answer uses what the message states.
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
 The gap hardly closes: the answer is large and uncertain.
 */
#define PERCUSS_REMARK_NEARLY_IMMOVABLE 1

/*
 Some motions have no mass. They do not matter for a finite m̄.
 */
#define PERCUSS_REMARK_MASSLESS_MOTIONS 2

/*
 The contact is massless to rounding only.
 */
#define PERCUSS_REMARK_MASSLESS_TO_ROUNDING 4

/*
 A motion without mass leaves v* open; m̄ and the contributions are not.
 */
#define PERCUSS_REMARK_UNDETERMINED_MOTION 8

/*
 The rank of the constraints is unclear.
 */
#define PERCUSS_REMARK_UNCLEAR_RANK 16

/*
 The mass matrix has negative directions: m̄ is a stationary value, no minimum.
 */
#define PERCUSS_REMARK_INDEFINITE 32

/*
 Branches cross at this pose: m̄ is a lower bound that no branch attains.
 */
#define PERCUSS_REMARK_SINGULAR_POSE 64

/*
 The pose is on another assembly mode than that of the first closed pose (percuss_configuration_allow_other_assembly).
 */
#define PERCUSS_REMARK_OTHER_ASSEMBLY 128

/*
 A loop is open as drawn by more than a hundredth of its size: a point may be mistyped.
 */
#define PERCUSS_REMARK_DRAWN_OPEN 256

/*
 The loops contradict one another by rounding: closed in least squares.
 */
#define PERCUSS_REMARK_INEXACT_LOOPS 512

/*
 A driving joint was not set, and 0 is out of reach.
 */
#define PERCUSS_REMARK_DRIVER_OFF_ZERO 1024

/*
 A joint was set to more numbers than its loops leave degrees of freedom: the nearest position is taken.
 */
#define PERCUSS_REMARK_OFF_TARGET 2048

/*
 A joint is outside its limits. Workspaces and batches do not look at limits.
 */
#define PERCUSS_REMARK_OUTSIDE_LIMITS 4096

/*
 A little off in the figures of the file, and the loops leave one motion more.
 */
#define PERCUSS_REMARK_WEAKLY_CONSTRAINED 8192

/*
 The generic rank of the constraints is unclear: the mobility may be another.
 */
#define PERCUSS_REMARK_UNCLEAR_MOBILITY 16384

/*
 The normal is given in the world and the base floats, but its pose was not given: it is taken at the world's origin
 (percuss_configuration_set_base, percuss_workspace_set_base).
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
 In batches, a row without an answer: its loops are open.
 */
#define PERCUSS_REMARK_OPEN_LOOPS 262144

/*
 In batches, a row without an answer for another reason.
 */
#define PERCUSS_REMARK_NO_ANSWER 524288

/*
 F = k xᵖ + c x^((p−1)/2) ẋ.
 */
#define PERCUSS_DAMPER_KELVIN_VOIGT 0

/*
 F = k xᵖ (1 + d ẋ).
 */
#define PERCUSS_DAMPER_HUNT_CROSSLEY 1

/*
 A system whose loops are put together. Cannot be changed: threads may share it.
 */
typedef struct percuss_assembly percuss_assembly;

/*
 One contact, ready for many configurations. Cannot be changed: threads may share it.
 */
typedef struct percuss_batch percuss_batch;

/*
 Conditions of an analysis. One thread at a time.
 */
typedef struct percuss_conditions percuss_conditions;

/*
 Positions of the joints, and where the root link stands in the world. One thread at a time.
 */
typedef struct percuss_configuration percuss_configuration;

/*
 A mechanism. Cannot be changed: threads may share it.
 */
typedef struct percuss_model percuss_model;

/*
 A mechanism at one configuration, its loops closed. Cannot be changed: threads may share it.
 */
typedef struct percuss_pose percuss_pose;

/*
 A response to a contact: m̄, v*, contributions. Cannot be changed: threads may share it.
 */
typedef struct percuss_response percuss_response;

/*
 A mechanism under conditions. Cannot be changed: threads may share it.
 */
typedef struct percuss_system percuss_system;

/*
 Room to pose an assembly again and again and to ask for m̄. One thread at a time: each thread its own.
 */
typedef struct percuss_workspace percuss_workspace;

/*
 What a call came to: PERCUSS_OK, or one of the errors.
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
   Its name, as long as the model lives.
   */
  const char *name;
  /*
   A percuss_joint_kind.
   */
  percuss_joint_kind kind;
  /*
   1 where it has limits.
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
   How many positions it has, and which of the mechanism's is the first.
   */
  size_t positions;
  /*
   See positions.
   */
  size_t first_position;
  /*
   How many velocities it has, and which of the mechanism's is the first.
   */
  size_t velocities;
  /*
   See velocities.
   */
  size_t first_velocity;
  /*
   The link that carries it, and the one that it carries: numbers of links.
   */
  size_t parent;
  /*
   See parent.
   */
  size_t child;
} percuss_joint;

/*
 Something that was noticed in a file.
 */
typedef struct percuss_diagnostic {
  /*
   PERCUSS_NOTE or PERCUSS_WARNING; errors make the load fail.
   */
  int32_t severity;
  /*
   Line, from 1; 0 where it has none.
   */
  uint32_t line;
  /*
   Column in characters, from 1; 0 where it has none.
   */
  uint32_t column;
  /*
   A short name that programs can rely on. The texts live as long as the model.
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
 Where a normal is given.
 */
typedef int32_t percuss_normal;

/*
 A contact between a point of a link and another link, or the ground. Fill it with percuss_contact_init first.
 */
typedef struct percuss_contact {
  /*
   The struck link: a number of percuss_model_find_link. PERCUSS_NO_LINK, from percuss_contact_init, is an error.
   */
  size_t link;
  /*
   The other side: a link, or PERCUSS_GROUND.
   */
  size_t against;
  /*
   The contact point in the struck link's frame, m.
   */
  double point[3];
  /*
   The normal, out of the struck link into the other side; its length does not matter. For PERCUSS_NORMAL_TOWARD and
   PERCUSS_NORMAL_TURNING_TOWARD the point that it points towards, m.
   */
  double normal[3];
  /*
   Where the normal is given: PERCUSS_NORMAL_LINK to PERCUSS_NORMAL_TURNING_TOWARD.
   */
  percuss_normal normal_given;
  /*
   For both of them the link whose point is meant; not read otherwise.
   */
  size_t toward;
} percuss_contact;

/*
 How m̄ is computed.
 */
typedef int32_t percuss_route;

/*
 What the mechanism opposes to the contact.
 */
typedef int32_t percuss_outcome;

/*
 An effective mass with what is known of it. A number that is not known, or that does not apply, is NaN.
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
   Motions that the constraints leave; a floating base's 6 included.
   */
  size_t degrees_of_freedom;
  /*
   m̄, kg; NaN unless the outcome is PERCUSS_FINITE.
   */
  double effective_mass;
  /*
   What m̄ may be off by, kg: the sum of what is known. NaN where rounding or closing is not known.
   */
  double error;
  /*
   The part by rounding, kg.
   */
  double error_rounding;
  /*
   The part by what the loops' residual leaves open, kg.
   */
  double error_closing;
  /*
   The part by how far the file's loops are from fitting, kg; NaN where no redundant rows measure it.
   */
  double error_file;
} percuss_mass;

/*
 How the entries of a matrix lie in memory.
 */
typedef int32_t percuss_layout;

/*
 Asked now and then with the number of configurations done, on the calling thread; gives 0 to go on, else the work stops. It must
 not use the batch and must not throw.
 */
typedef int32_t (*percuss_watch)(size_t done, void *user);

/*
 A contact law: its number. percuss_law_find gives it.
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
 When a contact ends, for a law whose force would pull before the gap closes.
 */
typedef int32_t percuss_separation;

/*
 A damper in parallel with the spring.
 */
typedef struct percuss_damper {
  /*
   PERCUSS_DAMPER_KELVIN_VOIGT or PERCUSS_DAMPER_HUNT_CROSSLEY.
   */
  int32_t kind;
  /*
   Of a Kelvin–Voigt damper: when the contact ends.
   */
  percuss_separation separation;
  /*
   Of a Kelvin–Voigt damper: c, N·s/m^((p+1)/2), N·s/m where p = 1; else NaN.
   */
  double coefficient;
  /*
   Of a Kelvin–Voigt damper: the damping ratio ζ on the contact that it was made for; else NaN.
   */
  double ratio;
  /*
   Of a Hunt–Crossley damper: d, s/m; else NaN.
   */
  double dissipation;
} percuss_damper;

/*
 The figures of one impact.
 */
typedef struct percuss_impact {
  /*
   Rebound speed over approach speed.
   */
  double restitution;
  /*
   From the first touch to the end, s; NaN where the gap takes forever to close.
   */
  double duration;
  /*
   m.
   */
  double max_penetration;
  /*
   From the first touch, s.
   */
  double time_of_max_penetration;
  /*
   The greatest push, N.
   */
  double peak_force;
  /*
   From the first touch, s.
   */
  double time_of_peak_force;
  /*
   J.
   */
  double energy_lost;
  /*
   m/s.
   */
  double rebound_speed;
} percuss_impact;

/*
 How matrices are read. Fill it with percuss_matrix_options_init first.
 */
typedef struct percuss_matrix_options {
  /*
   How coordinates are scaled where ranks are decided: for each, how far a unit rate of it moves things, in one unit for all
   (1 for a slide in metres, a typical length for an angle). null: 1 for all.
   */
  const double *lengths;
  /*
   How many lengths there are: one for each coordinate, or 0.
   */
  size_t length_count;
  /*
   Singular values of A below this part of the largest count as zero; above 0, at most 0.1. 1e-10.
   */
  double rank_floor;
  /*
   Relative error of every entry of M, A and j, 0 to 1e-3; it enters the stated error. 2.2e-16.
   */
  double accuracy;
} percuss_matrix_options;

/*
 A matrix of the caller's, read where it lies.
 */
typedef struct percuss_matrix {
  /*
   The entries; null only where there are none.
   */
  const double *values;
  /*
   How many numbers there are at values: (rows − 1) · leading_dimension + columns at least, row by row;
   (columns − 1) · leading_dimension + rows column by column.
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
   How far rows (row by row) or columns (column by column) are apart, as in BLAS.
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
 What was decided about the rows of A.
 */
typedef struct percuss_rank {
  /*
   How many rows are independent.
   */
  size_t rank;
  /*
   How many are not.
   */
  size_t redundant;
  /*
   Least gap between singular values that count and those that do not; NaN without rows.
   */
  double gap;
  /*
   1 where no singular value is within a factor of 30 of the threshold.
   */
  int32_t is_clear;
  /*
   0.
   */
  uint32_t reserved;
} percuss_rank;

/*
 All is well.
 */
#define PERCUSS_OK 0

/*
 A pointer is null, or not aligned.
 */
#define PERCUSS_ERROR_NULL 1

/*
 A handle is not of the kind that is expected. Freed handles are noticed where their memory was not used again.
 */
#define PERCUSS_ERROR_HANDLE 2

/*
 An array has not the length that is needed, or a matrix not the shape or the leading dimension.
 */
#define PERCUSS_ERROR_LENGTH 3

/*
 A number is out of range, NaN or infinite where it must not be, or no value of its enumeration.
 */
#define PERCUSS_ERROR_ARGUMENT 4

/*
 A text is not UTF-8.
 */
#define PERCUSS_ERROR_TEXT 5

/*
 There is no link, joint, law or other thing of this name or number.
 */
#define PERCUSS_ERROR_NAME 6

/*
 A model cannot be read; the message has every error with its file and line.
 */
#define PERCUSS_ERROR_LOAD 7

/*
 Conditions do not fit the mechanism, or a joint cannot be set so.
 */
#define PERCUSS_ERROR_CONDITIONS 8

/*
 Loops do not close, or drivers cannot get where they are set.
 */
#define PERCUSS_ERROR_ASSEMBLY 9

/*
 A contact means nothing, or has no answer.
 */
#define PERCUSS_ERROR_CONTACT 10

/*
 Matrices ask nothing: not symmetric, indefinite, too large.
 */
#define PERCUSS_ERROR_MATRIX 11

/*
 A contact law does not give what is asked.
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
 Arrays or places that a call writes overlap one another, or what it reads.
 */
#define PERCUSS_ERROR_OVERLAP 15

/*
 A defect of percuss. The object that was used may be freed, and should not be used otherwise.
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
 A vector in the struck link's frame: it turns with the link.
 */
#define PERCUSS_NORMAL_LINK 0

/*
 A vector in the world's frame.
 */
#define PERCUSS_NORMAL_WORLD 1

/*
 A vector in the other link's frame (the world's, where that is the ground).
 */
#define PERCUSS_NORMAL_AGAINST 2

/*
 From the contact point towards a point (m) of another link, in that link's frame.
 Refused where that line has turned by more than 5° from the line as drawn, or is shorter than a tenth of it.
 */
#define PERCUSS_NORMAL_TOWARD 3

/*
 The same line, which may turn: a spring, a damper or a rod. Refused where it is shorter than a tenth of the line as drawn.
 */
#define PERCUSS_NORMAL_TURNING_TOWARD 4

/*
 A number.
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
 In batches: no answer; the remarks have the reason, percuss_workspace_effective_mass at that configuration states it.
 */
#define PERCUSS_NO_ANSWER 3

/*
 In batches: massless to rounding only; the error is the largest m̄, kg, that the contact may have.
 */
#define PERCUSS_MASSLESS_TO_ROUNDING 4

/*
 The recursion where it is accurate, else the careful route.
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
 Column by column, as Fortran and BLAS have it: entry (r, c) at c · leading_dimension + r.
 */
#define PERCUSS_COLUMN_MAJOR 1

/*
 A spring in parallel with a damper, solved exactly.
 */
#define PERCUSS_LAW_KELVIN_VOIGT 0

/*
 A damper that stiffens with the spring, solved exactly.
 */
#define PERCUSS_LAW_HUNT_CROSSLEY 1

/*
 When the force has fallen to zero: contacts that do not stick, and simulators that take max(0, F).
 */
#define PERCUSS_FORCE_VANISHES 0

/*
 When the spring has its free length again; the damper pulls shortly before.
 */
#define PERCUSS_GAP_CLOSES 1

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/*
 The message of the last call that failed on this thread: what, where, got, expected; UTF-8, "" where none failed. It stays where it
 is until the next call of this thread fails.
 */
const char *percuss_error_message(void);

/*
 The version of the library, such as "0.1.0". That of the header is PERCUSS_VERSION. While the first number is 0, the
 second changes with every change that programs must be compiled again for.
 */
const char *percuss_version(void);

/*
 Reads a URDF file, closed loops and couplings included. path: UTF-8. Free the model with percuss_model_free.

 Errors: PERCUSS_ERROR_LOAD, with every error of the file in the message.

 Pointers:
 path ends with a zero byte; model is null or a place for a pointer.
 */
percuss_status percuss_model_load_file(const char *path, struct percuss_model **model);

/*
 Reads a URDF from memory: length bytes of UTF-8, no zero byte needed. name stands for the file in messages.

 Errors: as percuss_model_load_file; PERCUSS_ERROR_TEXT.

 Pointers:
 name ends with a zero byte; bytes has length bytes; model is null or a place for a pointer.
 */
percuss_status percuss_model_load_memory(const char *name,
                                         const char *bytes,
                                         size_t length,
                                         struct percuss_model **model);

/*
 Frees a model and sets the handle to null; nothing where it is null. What was made from the model stays valid.

 Pointers:
 model is null or the place of a handle that nobody uses.
 */
percuss_status percuss_model_free(struct percuss_model **model);

/*
 How many links a model has, joints, positions of all joints, and velocities of all joints. Each place may be null.

 Pointers:
 Every pointer is null or a place for a number.
 */
percuss_status percuss_model_counts(const struct percuss_model *model,
                                    size_t *links,
                                    size_t *joints,
                                    size_t *positions,
                                    size_t *velocities);

/*
 The name of link number index, from 0. It lives as long as the model; null where the call fails.

 Pointers:
 name is null or a place for a pointer.
 */
percuss_status percuss_model_link_name(const struct percuss_model *model, size_t index, const char **name);

/*
 The number of the link of this name. Errors: PERCUSS_ERROR_NAME, with the most similar name.

 Pointers:
 name ends with a zero byte; index is null or a place for a number.
 */
percuss_status percuss_model_find_link(const struct percuss_model *model, const char *name, size_t *index);

/*
 The number of the joint of this name. Errors: PERCUSS_ERROR_NAME, with the most similar name.

 Pointers:
 name ends with a zero byte; index is null or a place for a number.
 */
percuss_status percuss_model_find_joint(const struct percuss_model *model, const char *name, size_t *index);

/*
 Joint number index, from 0.

 Pointers:
 joint is null or a place for a percuss_joint.
 */
percuss_status percuss_model_joint(const struct percuss_model *model, size_t index, struct percuss_joint *joint);

/*
 How many notes and warnings came of the file.

 Pointers:
 count is null or a place for a number.
 */
percuss_status percuss_model_diagnostic_count(const struct percuss_model *model, size_t *count);

/*
 Note or warning number index, from 0, in the order of the file.

 Pointers:
 diagnostic is null or a place for a percuss_diagnostic.
 */
percuss_status percuss_model_diagnostic(const struct percuss_model *model,
                                        size_t index,
                                        struct percuss_diagnostic *diagnostic);

/*
 Fixed base, everything free, armatures as declared. Free them with percuss_conditions_free.

 Pointers:
 conditions is null or a place for a pointer.
 */
percuss_status percuss_conditions_new(struct percuss_conditions **conditions);

/*
 Frees conditions and sets the handle to null; nothing where it is null.

 Pointers:
 conditions is null or the place of a handle that nobody uses.
 */
percuss_status percuss_conditions_free(struct percuss_conditions **conditions);

/*
 How the root link stands: PERCUSS_BASE_FIXED (the default) or PERCUSS_BASE_FLOATING.

 Pointers:
 conditions is null or a handle.
 */
percuss_status percuss_conditions_base(struct percuss_conditions *conditions, int32_t base);

/*
 Holds a joint at its position: its velocities are zero. That there is such a joint is checked by percuss_system_new.

 Pointers:
 joint ends with a zero byte.
 */
percuss_status percuss_conditions_lock(struct percuss_conditions *conditions, const char *joint);

/*
 Replaces a joint's armature (the rotor's inertia at the joint, kg·m² or kg): one value for all its velocities, or
 count of them. Checked by percuss_system_new.

 Pointers:
 joint ends with a zero byte; values has count numbers.
 */
percuss_status percuss_conditions_armature(struct percuss_conditions *conditions,
                                           const char *joint,
                                           const double *values,
                                           size_t count);

/*
 Holds a point (3 numbers, m, link's frame) of a link to the ground: along a normal (3 numbers, root link's axes), or in
 all directions where that is null. Velocities only. Checked by percuss_system_new.

 Pointers:
 link ends with a zero byte; point has 3 numbers; normal is null or has 3.
 */
percuss_status percuss_conditions_hold(struct percuss_conditions *conditions,
                                       const char *link,
                                       const double *point,
                                       const double *normal);

/*
 Every joint at zero (quaternions at 1, 0, 0, 0), the root link at the world's origin. Free it with percuss_configuration_free.

 Pointers:
 model is a handle; configuration is null or a place for a pointer.
 */
percuss_status percuss_configuration_new(const struct percuss_model *model,
                                         struct percuss_configuration **configuration);

/*
 Frees a configuration and sets the handle to null; nothing where it is null.

 Pointers:
 configuration is null or the place of a handle that nobody uses.
 */
percuss_status percuss_configuration_free(struct percuss_configuration **configuration);

/*
 Every joint at zero again, nothing set and nothing guessed.

 Pointers:
 configuration is null or a handle.
 */
percuss_status percuss_configuration_reset(struct percuss_configuration *configuration);

/*
 Sets a driving joint to count values (layouts of percuss_joint_kind). Joints of loops that are not set follow.

 Errors: PERCUSS_ERROR_CONDITIONS: no such joint, set twice, a mimic, another number of values, a value that is none.

 Pointers:
 joint ends with a zero byte; values has count numbers.
 */
percuss_status percuss_configuration_set(struct percuss_configuration *configuration,
                                         const char *joint,
                                         const double *values,
                                         size_t count);

/*
 Sets where to look for a joint that follows from loops: which assembly mode is meant.

 Errors: as percuss_configuration_set.

 Pointers:
 As percuss_configuration_set.
 */
percuss_status percuss_configuration_guess(struct percuss_configuration *configuration,
                                           const char *joint,
                                           const double *values,
                                           size_t count);

/*
 Sets a whole configuration: the positions of all joints one after another, in joint order; those of mimics are not read. Loops
 are closed from there. What was set before is forgotten.

 Errors: PERCUSS_ERROR_CONDITIONS.

 Pointers:
 positions has count numbers.
 */
percuss_status percuss_configuration_set_positions(struct percuss_configuration *configuration,
                                                   const double *positions,
                                                   size_t count);

/*
 Sets where the root link stands in the world: its origin (3 numbers, m) and its orientation (4 numbers, a unit quaternion w, x,
 y, z: a norm within 0.01 of 1, which is normalised).

 Errors: PERCUSS_ERROR_ARGUMENT: a number that is not finite, another norm.

 Pointers:
 position has 3 numbers, quaternion 4.
 */
percuss_status percuss_configuration_set_base(struct percuss_configuration *configuration,
                                              const double *position,
                                              const double *quaternion);

/*
 Accepts a pose on another assembly mode, where the branch of the first closed pose does not reach the driving joints. Such a
 pose has PERCUSS_REMARK_OTHER_ASSEMBLY; without this it is PERCUSS_ERROR_ASSEMBLY. A guess chooses a mode by itself.

 Pointers:
 configuration is null or a handle.
 */
percuss_status percuss_configuration_allow_other_assembly(struct percuss_configuration *configuration);

/*
 Compiles a mechanism with the conditions of an analysis; null: fixed base, everything free. The model and the conditions may be
 freed afterwards. Free the system with percuss_system_free.

 Errors: PERCUSS_ERROR_CONDITIONS.

 Pointers:
 model is a handle; conditions is null or a handle; system is null or a place for a pointer.
 */
percuss_status percuss_system_new(const struct percuss_model *model,
                                  const struct percuss_conditions *conditions,
                                  struct percuss_system **system);

/*
 Frees a system and sets the handle to null; nothing where it is null. What was made from it stays valid.

 Pointers:
 system is null or the place of a handle that nobody uses.
 */
percuss_status percuss_system_free(struct percuss_system **system);

/*
 How many coordinates there are: independent velocities of the tree, without locked joints and mimics; a floating base
 counts 6. The order is that of the base, then of the joints from the root.

 Pointers:
 coordinates is null or a place for a number.
 */
percuss_status percuss_system_coordinates(const struct percuss_system *system, size_t *coordinates);

/*
 Puts loops together: from all joints at 0 where configuration is null, else from its guesses. A mechanism without loops has
 one assembly. Free it with percuss_assembly_free.

 Errors: PERCUSS_ERROR_ASSEMBLY, naming the loop that does not close.

 Pointers:
 system is a handle; configuration is null or a handle; assembly is null or a place for a pointer.
 */
percuss_status percuss_assembly_new(const struct percuss_system *system,
                                    const struct percuss_configuration *configuration,
                                    struct percuss_assembly **assembly);

/*
 Frees an assembly and sets the handle to null; nothing where it is null. What was made from it stays valid.

 Pointers:
 assembly is null or the place of a handle that nobody uses.
 */
percuss_status percuss_assembly_free(struct percuss_assembly **assembly);

/*
 Degrees of freedom at a generic pose (a floating base counts 6), and rows of A that are redundant there. Each place may be
 null.

 Pointers:
 Every pointer is null or a place for a number.
 */
percuss_status percuss_assembly_mobility(const struct percuss_assembly *assembly,
                                         size_t *degrees_of_freedom,
                                         size_t *redundant_constraints);

/*
 A contact with the ground at the origin of a link, which must be set (PERCUSS_NO_LINK), along a normal in the link's frame, which
 must be set too (0, 0, 0).

 Pointers:
 contact is null or a place for a percuss_contact.
 */
percuss_status percuss_contact_init(struct percuss_contact *contact);

/*
 The pose at a configuration: joints that were set drive, the others of the loops follow. Of the assembly found from all joints
 at 0, or, where nothing closes from there, of that found from the configuration's guesses. Free it with percuss_pose_free.

 Errors: PERCUSS_ERROR_ASSEMBLY: loops that do not close, drivers that cannot get there, a dependent joint that was set.

 Pointers:
 system and configuration are handles; pose is null or a place for a pointer.
 */
percuss_status percuss_pose_new(const struct percuss_system *system,
                                const struct percuss_configuration *configuration,
                                struct percuss_pose **pose);

/*
 The same of a given assembly.

 Pointers:
 assembly and configuration are handles; pose is null or a place for a pointer.
 */
percuss_status percuss_assembly_pose(const struct percuss_assembly *assembly,
                                     const struct percuss_configuration *configuration,
                                     struct percuss_pose **pose);

/*
 The pose at a configuration on the branch of another pose of the same assembly, followed from there: for steps of a motion.

 Pointers:
 from and configuration are handles; pose is null or a place for a pointer, not the place of from.
 */
percuss_status percuss_pose_follow(const struct percuss_pose *from,
                                   const struct percuss_configuration *configuration,
                                   struct percuss_pose **pose);

/*
 Frees a pose and sets the handle to null; nothing where it is null.

 Pointers:
 pose is null or the place of a handle that nobody uses.
 */
percuss_status percuss_pose_free(struct percuss_pose **pose);

/*
 The positions of all joints one after another, in joint order, mimics included: count is that of percuss_model_counts.

 Pointers:
 positions has room for count numbers.
 */
percuss_status percuss_pose_positions(const struct percuss_pose *pose, double *positions, size_t count);

/*
 m̄ of a contact, with its error. route: PERCUSS_ROUTE_AUTO, unless another is wanted.

 Errors: PERCUSS_ERROR_CONTACT: a contact that means nothing, or that the route does not take.

 Pointers:
 pose is a handle; contact is null or points to a contact; mass is null or a place for a percuss_mass.
 */
percuss_status percuss_pose_effective_mass(const struct percuss_pose *pose,
                                           const struct percuss_contact *contact,
                                           percuss_route route,
                                           struct percuss_mass *mass);

/*
 The whole response to a contact: v* and the contributions as well. Free it with percuss_response_free.

 Errors: as percuss_pose_effective_mass.

 Pointers:
 As percuss_pose_effective_mass; response is null or a place for a pointer.
 */
percuss_status percuss_pose_respond(const struct percuss_pose *pose,
                                    const struct percuss_contact *contact,
                                    percuss_route route,
                                    struct percuss_response **response);

/*
 M, the mass matrix over the coordinates, n×n (kg, kg·m, kg·m²), into room for length numbers.

 Pointers:
 values has room for length numbers.
 */
percuss_status percuss_pose_mass_matrix(const struct percuss_pose *pose,
                                        double *values,
                                        size_t length,
                                        percuss_layout layout,
                                        size_t leading_dimension);

/*
 How many rows A has, the redundant ones included.

 Pointers:
 rows is null or a place for a number.
 */
percuss_status percuss_pose_constraint_rows(const struct percuss_pose *pose, size_t *rows);

/*
 A, the Jacobian of all constraints over the coordinates, rows×n, into room for length numbers; each group of loops is scaled to
 entries of at most 1.

 Pointers:
 values has room for length numbers.
 */
percuss_status percuss_pose_constraint_matrix(const struct percuss_pose *pose,
                                              double *values,
                                              size_t length,
                                              percuss_layout layout,
                                              size_t leading_dimension);

/*
 j, the closing speed of a contact at unit rates of the coordinates, 1×n (m, 1): count is n.

 Pointers:
 contact is null or points to a contact; values has room for count numbers.
 */
percuss_status percuss_pose_contact_row(const struct percuss_pose *pose,
                                        const struct percuss_contact *contact,
                                        double *values,
                                        size_t count);

/*
 Frees a response and sets the handle to null; nothing where it is null.

 Pointers:
 response is null or the place of a handle that nobody uses.
 */
percuss_status percuss_response_free(struct percuss_response **response);

/*
 m̄ and its error.

 Pointers:
 mass is null or a place for a percuss_mass.
 */
percuss_status percuss_response_mass(const struct percuss_response *response, struct percuss_mass *mass);

/*
 The same where the other side is a free mass (kg) of its own: 1/m̄ = 1/m̄₁ + 1/m₂.

 Pointers:
 mass is null or a place for a percuss_mass.
 */
percuss_status percuss_response_against_mass(const struct percuss_response *response,
                                             double other,
                                             struct percuss_mass *mass);

/*
 v*: the velocities of all joints at unit closing speed (1/m·rad, 1), one after another in joint order; count is that of
 percuss_model_counts. Of a contact that is not finite too, where a motion is known; else zeros.

 Pointers:
 velocities has room for count numbers.
 */
percuss_status percuss_response_velocities(const struct percuss_response *response,
                                           double *velocities,
                                           size_t count);

/*
 v* of a floating root link: 3 angular and 3 linear numbers, in its axes at its origin; zeros where it is the ground.

 Pointers:
 twist has room for 6 numbers.
 */
percuss_status percuss_response_base_velocity(const struct percuss_response *response, double *twist);

/*
 The contribution of each link to m̄, in link order (links numbers), and of the rotor of each joint (joints numbers): together 1.
 Errors: PERCUSS_ERROR_CONTACT where m̄ is not finite.

 Pointers:
 links has room for link_count numbers, rotors for joint_count; rotors may be null.
 */
percuss_status percuss_response_contributions(const struct percuss_response *response,
                                              double *links,
                                              size_t link_count,
                                              double *rotors,
                                              size_t joint_count);

/*
 Room for many poses of an assembly; it stands at its first closed pose. Free it with percuss_workspace_free.

 Pointers:
 assembly is a handle; workspace is null or a place for a pointer.
 */
percuss_status percuss_workspace_new(const struct percuss_assembly *assembly, struct percuss_workspace **workspace);

/*
 Frees a workspace and sets the handle to null; nothing where it is null.

 Pointers:
 workspace is null or the place of a handle that nobody uses.
 */
percuss_status percuss_workspace_free(struct percuss_workspace **workspace);

/*
 m̄ of a contact at the positions of all joints (one after another, in joint order; unit quaternions; those of mimics are not
 read): count numbers, as percuss_model_counts says. Loops must be closed there, to a millionth of their size: positions of a pose
 of the same assembly are.

 effective_mass: kg; NaN unless the outcome is PERCUSS_FINITE. remarks: null, or a place for PERCUSS_REMARK_… added together. States
 no error: percuss_pose_effective_mass does. Allocates nothing after the first call, but where the recursion is not accurate
 enough. Normals in the world are taken with the root link where percuss_workspace_set_base has put it, else at the world's
 origin.

 Errors: PERCUSS_ERROR_NULL, PERCUSS_ERROR_LENGTH; PERCUSS_ERROR_ARGUMENT: a position that matters is not finite, a quaternion is not
 of unit length; PERCUSS_ERROR_ASSEMBLY: a loop is open, with the gap and the tolerance; PERCUSS_ERROR_CONTACT; PERCUSS_ERROR_OVERLAP;
 PERCUSS_ERROR_BUSY where another thread uses the workspace.

 Pointers:
 workspace is a handle; positions is null or has count numbers; contact is null or points to a contact; the other pointers are null
 or places.
 */
percuss_status percuss_workspace_effective_mass(struct percuss_workspace *workspace,
                                                const double *positions,
                                                size_t count,
                                                const struct percuss_contact *contact,
                                                percuss_outcome *outcome,
                                                double *effective_mass,
                                                uint32_t *remarks);

/*
 The same of another contact at the positions last given to the workspace; at its first closed pose where none were.

 Errors: as percuss_workspace_effective_mass.

 Pointers:
 As percuss_workspace_effective_mass.
 */
percuss_status percuss_workspace_effective_mass_again(struct percuss_workspace *workspace,
                                                      const struct percuss_contact *contact,
                                                      percuss_outcome *outcome,
                                                      double *effective_mass,
                                                      uint32_t *remarks);

/*
 Sets where the root link stands in the world, as percuss_configuration_set_base: for normals that are given in the world.

 Errors: PERCUSS_ERROR_ARGUMENT.

 Pointers:
 workspace is a handle; position has 3 numbers, quaternion 4.
 */
percuss_status percuss_workspace_set_base(struct percuss_workspace *workspace,
                                          const double *position,
                                          const double *quaternion);

/*
 Room to ask for m̄ of one contact at many configurations of an assembly, by so many threads (at most 1024), which belong to the
 batch; 1: the calling thread alone, 0: as many as the machine has processors. Normals in the world are taken with the root link
 at the world's origin; percuss_workspace_batch has another base. Free it with percuss_batch_free.

 Errors: PERCUSS_ERROR_CONTACT, PERCUSS_ERROR_ARGUMENT.

 Pointers:
 assembly is a handle; contact is null or points to a contact; batch is null or a place for a pointer.
 */
percuss_status percuss_batch_new(const struct percuss_assembly *assembly,
                                 const struct percuss_contact *contact,
                                 size_t threads,
                                 struct percuss_batch **batch);

/*
 The same with the assembly and the base of a workspace (percuss_workspace_set_base), for normals in the world. The workspace may be
 used otherwise afterwards, or freed.

 Errors: as percuss_batch_new; PERCUSS_ERROR_BUSY.

 Pointers:
 workspace is a handle; contact is null or points to a contact; batch is null or a place for a pointer.
 */
percuss_status percuss_workspace_batch(struct percuss_workspace *workspace,
                                       const struct percuss_contact *contact,
                                       size_t threads,
                                       struct percuss_batch **batch);

/*
 Ends the threads of a batch, frees it and sets the handle to null; nothing where it is null.

 Pointers:
 batch is null or the place of a handle that nobody uses.
 */
percuss_status percuss_batch_free(struct percuss_batch **batch);

/*
 m̄ at count configurations, the positions of all joints each (p of them, as percuss_model_counts says; loops closed).

 positions: length numbers; PERCUSS_ROW_MAJOR: configuration c begins at c · stride, stride ≥ p; PERCUSS_COLUMN_MAJOR: position q of
 configuration c stands at q · stride + c, stride ≥ count: the fastest. outcomes and effective_masses: count values each, as
 percuss_workspace_effective_mass has them; PERCUSS_NO_ANSWER where there is none, PERCUSS_MASSLESS_TO_ROUNDING where rounding
 may hide a mass. errors: null, or room for count numbers: the error by rounding, kg; NaN where it was not counted; of a contact that
 is massless to rounding only, the largest m̄ that it may have. remarks: null, or room for count numbers: PERCUSS_REMARK_… added
 together, the reason of a row without an answer among them. watch: null, or asked now and then with user, in the default
 floating-point environment. What is written must not overlap, and must not overlap the positions.

 Errors: PERCUSS_ERROR_LENGTH; PERCUSS_ERROR_OVERLAP; PERCUSS_ERROR_STOPPED: what was answered until then is there, the rest is PERCUSS_NO_ANSWER.
 PERCUSS_ERROR_HANDLE: the process was forked since the batch was made, whose threads are the parent's.

 Pointers:
 batch is a handle; every array has as many values as is said; watch may be called with user.
 */
percuss_status percuss_batch_run(const struct percuss_batch *batch,
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
 How many laws there are: their numbers are 0 to this − 1.
 */
size_t percuss_law_count(void);

/*
 The name of a law; it lives as long as the program.

 Pointers:
 name is null or a place for a pointer.
 */
percuss_status percuss_law_name(percuss_law law, const char **name);

/*
 The law of this name or alias, upper and lower case alike. Errors: PERCUSS_ERROR_NAME, with the most similar name.

 Pointers:
 name ends with a zero byte; law is null or a place for a number.
 */
percuss_status percuss_law_find(const char *name, percuss_law *law);

/*
 The damper of a law for the restitution e on this spring, at the approach speed in m/s; 0 where the law needs none
 (Kelvin–Voigt does not). separation matters to Kelvin–Voigt alone.

 Errors: PERCUSS_ERROR_LAW: out of range, the speed missing, an e that the law does not reach.

 Pointers:
 spring is null or points to one; damper is null or a place for one.
 */
percuss_status percuss_law_damper(percuss_law law,
                                  const struct percuss_spring *spring,
                                  double restitution,
                                  double speed,
                                  percuss_separation separation,
                                  struct percuss_damper *damper);

/*
 The restitution that a damper gives on this spring at this approach speed, m/s. Exact for the force.

 Errors: PERCUSS_ERROR_LAW.

 Pointers:
 spring and damper are null or point to one; restitution is null or a place for a number.
 */
percuss_status percuss_damper_restitution(const struct percuss_damper *damper,
                                          const struct percuss_spring *spring,
                                          double speed,
                                          double *restitution);

/*
 The figures of the impact on this spring at this approach speed, m/s.

 Errors: PERCUSS_ERROR_LAW.

 Pointers:
 spring and damper are null or point to one; impact is null or a place for one.
 */
percuss_status percuss_damper_impact(const struct percuss_damper *damper,
                                     const struct percuss_spring *spring,
                                     double speed,
                                     struct percuss_impact *impact);

/*
 The defaults.

 Pointers:
 options is null or a place for percuss_matrix_options.
 */
percuss_status percuss_matrix_options_init(struct percuss_matrix_options *options);

/*
 m̄ = min { vᵀMv : Av = 0, jv = 1 } of a system that is given by its matrices: mass is M, n×n, symmetric, positive semi-definite (kg,
 kg·m, kg·m²); contact_row is j, count = n numbers (m, 1); constraints is A, m×n, or null. M may be singular, rows of A redundant.

 mass_result: the outcome, m̄ (kg), what it may be off by (error and error_rounding), the remarks. velocities: null, or room for n
 numbers: v*, the velocities at unit closing speed. rank: null, or a place for the report on A. redundant_rows: null, or
 room for m bytes: 1 for each row of A that follows from those that count, else 0. options: null for the defaults.

 Errors: PERCUSS_ERROR_LENGTH: shapes; PERCUSS_ERROR_ARGUMENT: NaN, infinities, options; PERCUSS_ERROR_MATRIX: not symmetric,
 not positive semi-definite, more than 1000 coordinates.

 Pointers:
 Every pointer is null or points to what is said; the arrays of the matrices have as many numbers as they say.
 */
percuss_status percuss_effective_mass(const struct percuss_matrix *mass,
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
