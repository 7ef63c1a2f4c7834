/* Layouts of the interface types on 64-bit machines: programs compiled with one header work with any library of the
   same second version number. C11 and C++17. */
#include <percuss.h>

#include <stddef.h>

#ifdef __cplusplus
#define ASSERT(condition) static_assert(condition, #condition)
#else
#define ASSERT(condition) _Static_assert(condition, #condition)
#endif

#define AT(type, field, offset) ASSERT(offsetof(type, field) == (offset))

ASSERT(sizeof(void *) == 8 && sizeof(size_t) == 8);
ASSERT(sizeof(percuss_status) == 4);
ASSERT(sizeof(percuss_contact) == 80);
AT(percuss_contact, link, 0);
AT(percuss_contact, against, 8);
AT(percuss_contact, point, 16);
AT(percuss_contact, normal, 40);
AT(percuss_contact, normal_given, 64);
AT(percuss_contact, toward, 72);
ASSERT(sizeof(percuss_mass) == 64);
AT(percuss_mass, outcome, 0);
AT(percuss_mass, route, 4);
AT(percuss_mass, remarks, 8);
AT(percuss_mass, degrees_of_freedom, 16);
AT(percuss_mass, effective_mass, 24);
AT(percuss_mass, error, 32);
AT(percuss_mass, error_file, 56);
ASSERT(sizeof(percuss_workspace_response) == 72);
AT(percuss_workspace_response, effective_mass, 8);
AT(percuss_workspace_response, error, 16);
AT(percuss_workspace_response, base_velocity, 24);
ASSERT(sizeof(percuss_rigid_impact) == 24);
AT(percuss_rigid_impact, energy_loss, 8);
AT(percuss_rigid_impact, residual, 16);
ASSERT(sizeof(percuss_joint) == 80);
AT(percuss_joint, lower, 16);
AT(percuss_joint, positions, 32);
AT(percuss_joint, child, 72);
ASSERT(sizeof(percuss_joint_description) == 200);
AT(percuss_joint_description, position, 32);
AT(percuss_joint_description, lower, 112);
AT(percuss_joint_description, armature, 128);
AT(percuss_joint_description, mimics, 176);
ASSERT(sizeof(percuss_closure_description) == 200);
AT(percuss_closure_description, predecessor_position, 32);
AT(percuss_closure_description, axis, 144);
AT(percuss_closure_description, distance, 192);
ASSERT(sizeof(percuss_pose_state) == 48);
AT(percuss_pose_state, remarks, 16);
AT(percuss_pose_state, closure_residual, 40);
ASSERT(sizeof(percuss_diagnostic) == 40);
AT(percuss_diagnostic, code, 16);
ASSERT(sizeof(percuss_matrix) == 48);
AT(percuss_matrix, layout, 40);
ASSERT(sizeof(percuss_matrix_options) == 64);
AT(percuss_matrix_options, accuracy, 24);
AT(percuss_matrix_options, row_noise, 56);
ASSERT(sizeof(percuss_rank) == 32);
ASSERT(sizeof(percuss_spring) == 24);
ASSERT(sizeof(percuss_damper) == 32);
ASSERT(sizeof(percuss_impact) == 64);
ASSERT(sizeof(percuss_vehicle) == 96);
AT(percuss_vehicle, axle, 32);
AT(percuss_vehicle, brake_bias, 48);
ASSERT(sizeof(percuss_column) == 24);
ASSERT(PERCUSS_OK == 0 && PERCUSS_ERROR_INTERNAL == 99);
ASSERT(PERCUSS_FINITE == 0 && PERCUSS_IMMOVABLE == 1 && PERCUSS_MASSLESS == 2 && PERCUSS_NO_ANSWER == 3 &&
       PERCUSS_MASSLESS_TO_ROUNDING == 4);
ASSERT(PERCUSS_ROW_MAJOR == 0 && PERCUSS_COLUMN_MAJOR == 1);
ASSERT(PERCUSS_GROUND == (size_t)-1);

int main(void) { return 0; }
