// percuss for C++17: a thin layer over percuss.h. Objects own their handles; failures are exceptions with a message.
//
// Model, Suspension, Kinematics, System, Assembly, Pose and Batch are immutable and may be shared between threads. A ModelBuilder, Conditions,
// Configuration or Workspace is for one thread at a time (otherwise percuss::Error with PERCUSS_ERROR_BUSY).
#ifndef PERCUSS_HPP
#define PERCUSS_HPP

#include "percuss.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace percuss {

/// Failure of a call: its status and message.
class Error : public std::runtime_error {
 public:
  Error(percuss_status status, const std::string &message) : std::runtime_error(message), status_(status) {}
  /// One of PERCUSS_ERROR_….
  [[nodiscard]] percuss_status status() const noexcept { return status_; }

 private:
  percuss_status status_;
};

/// Throws if a call failed.
inline void check(percuss_status status) {
  if (status != PERCUSS_OK) throw Error(status, percuss_error_message());
}

namespace detail {

template <class T, percuss_status (*Free)(T **)>
struct Deleter {
  void operator()(T *handle) const noexcept { Free(&handle); }
};

template <class T, percuss_status (*Free)(T **)>
using Owner = std::unique_ptr<T, Deleter<T, Free>>;

}  // namespace detail

using Contact = percuss_contact;
using Mass = percuss_mass;
using Spring = percuss_spring;
using Damper = percuss_damper;
using Impact = percuss_impact;
using Vector3 = std::array<double, 3>;

/// A mechanism read from URDF, MJCF or SDFormat.
class Model {
 public:
  /// Reads a file.
  [[nodiscard]] static Model load_file(const std::string &path) {
    percuss_model *handle = nullptr;
    check(percuss_model_load_file(path.c_str(), &handle));
    return Model(handle);
  }
  /// Reads the text of a model file; name replaces the file name in messages.
  [[nodiscard]] static Model load_text(std::string_view text, const std::string &name = "text.urdf") {
    percuss_model *handle = nullptr;
    check(percuss_model_load_memory(name.c_str(), text.data(), text.size(), &handle));
    return Model(handle);
  }
  /// Numbers of links, joints, positions of all joints and velocities of all joints.
  struct Counts {
    std::size_t links, joints, positions, velocities;
  };
  [[nodiscard]] Counts counts() const {
    Counts counts{};
    check(percuss_model_counts(get(), &counts.links, &counts.joints, &counts.positions, &counts.velocities));
    return counts;
  }
  [[nodiscard]] std::size_t find_link(const std::string &name) const {
    std::size_t index = 0;
    check(percuss_model_find_link(get(), name.c_str(), &index));
    return index;
  }
  [[nodiscard]] std::size_t find_joint(const std::string &name) const {
    std::size_t index = 0;
    check(percuss_model_find_joint(get(), name.c_str(), &index));
    return index;
  }
  /// The name of a link; valid as long as the model.
  [[nodiscard]] const char *link_name(std::size_t index) const {
    const char *name = nullptr;
    check(percuss_model_link_name(get(), index, &name));
    return name;
  }
  /// A joint; its name is valid as long as the model.
  [[nodiscard]] percuss_joint joint(std::size_t index) const {
    percuss_joint joint{};
    check(percuss_model_joint(get(), index, &joint));
    return joint;
  }
  /// Notes and warnings; their texts are valid as long as the model.
  [[nodiscard]] std::vector<percuss_diagnostic> diagnostics() const {
    std::size_t count = 0;
    check(percuss_model_diagnostic_count(get(), &count));
    std::vector<percuss_diagnostic> all(count);
    for (std::size_t i = 0; i < count; i++) check(percuss_model_diagnostic(get(), i, &all[i]));
    return all;
  }
  /// Names of the named poses (keyframes of MJCF).
  [[nodiscard]] std::vector<std::string> pose_names() const {
    std::size_t count = 0;
    check(percuss_model_pose_count(get(), &count));
    std::vector<std::string> names(count);
    for (std::size_t i = 0; i < count; i++) {
      const char *name = nullptr;
      check(percuss_model_pose_name(get(), i, &name));
      names[i] = name;
    }
    return names;
  }
  /// Positions of all joints at a named pose, for Configuration::set_positions.
  [[nodiscard]] std::vector<double> pose_positions(const std::string &name) const {
    std::vector<double> positions(counts().positions);
    check(percuss_model_pose_positions(get(), name.c_str(), positions.data(), positions.size()));
    return positions;
  }
  /// The positions of all joints for the positions qpos of MuJoCo, of a model that was read from its MJCF.
  [[nodiscard]] std::vector<double> positions_of_qpos(const std::vector<double> &qpos) const {
    std::vector<double> positions(counts().positions);
    check(percuss_model_positions_of_qpos(get(), qpos.data(), qpos.size(), positions.data(), positions.size()));
    return positions;
  }
  /// A contact of a point (m) of a link with the ground, along a normal out of the link, both in the link's frame.
  [[nodiscard]] Contact contact(const std::string &link, const Vector3 &point, const Vector3 &normal) const {
    Contact contact;
    check(percuss_contact_init(&contact));
    contact.link = find_link(link);
    for (std::size_t i = 0; i < 3; i++) {
      contact.point[i] = point[i];
      contact.normal[i] = normal[i];
    }
    return contact;
  }
  /// The named contact of the model: a stop, the seat of a spring or damper, a contact patch.
  [[nodiscard]] Contact named_contact(const std::string &name) const {
    Contact contact;
    check(percuss_model_find_contact(get(), name.c_str(), &contact, nullptr));
    return contact;
  }
  /// The gap of a named contact with all joints at 0, m; 0 if the parts always touch.
  [[nodiscard]] double gap_as_drawn(const std::string &name) const {
    Contact contact;
    double gap = 0.0;
    check(percuss_model_find_contact(get(), name.c_str(), &contact, &gap));
    return gap;
  }
  /// The results of the tables of a request, JSON: percuss_ask.
  [[nodiscard]] std::string ask(const std::string &request) const {
    percuss_report *handle = nullptr;
    check(percuss_ask(get(), request.c_str(), &handle));
    detail::Owner<percuss_report, percuss_report_free> report(handle);
    const char *json = nullptr;
    check(percuss_report_json(report.get(), &json));
    return json;
  }
  const percuss_model *get() const noexcept { return handle_.get(); }

 private:
  friend class Suspension;
  friend class ModelBuilder;
  explicit Model(percuss_model *handle) : handle_(handle) {}
  detail::Owner<percuss_model, percuss_model_free> handle_;
};

/// A joint between two links. Its texts are pointers that must be valid until ModelBuilder::joint returns.
struct JointDescription : percuss_joint_description {
  JointDescription() { check(percuss_joint_description_init(this)); }
};

/// A closure of a loop. Its texts are pointers that must be valid until ModelBuilder::closure returns.
struct ClosureDescription : percuss_closure_description {
  ClosureDescription() { check(percuss_closure_description_init(this)); }
};

/// Links, joints and closures of a model that is being built.
class ModelBuilder {
 public:
  explicit ModelBuilder(const std::string &name) {
    percuss_builder *handle = nullptr;
    check(percuss_builder_new(name.c_str(), &handle));
    handle_.reset(handle);
  }
  /// A link without mass.
  ModelBuilder &massless_link(const std::string &name) {
    check(percuss_builder_link(handle_.get(), name.c_str(), 0.0, nullptr, nullptr));
    return *this;
  }
  /// A link: mass (kg); centre of mass in the link's frame (m); inertia about the centre of mass, xx, xy, xz, yy, yz, zz (kg·m²).
  ModelBuilder &link(const std::string &name, double mass, const Vector3 &com, const std::array<double, 6> &inertia) {
    check(percuss_builder_link(handle_.get(), name.c_str(), mass, com.data(), inertia.data()));
    return *this;
  }
  ModelBuilder &joint(const JointDescription &description) {
    check(percuss_builder_joint(handle_.get(), &description));
    return *this;
  }
  ModelBuilder &closure(const ClosureDescription &description) {
    check(percuss_builder_closure(handle_.get(), &description));
    return *this;
  }
  /// The model; the builder stays usable.
  [[nodiscard]] Model model() const {
    percuss_model *handle = nullptr;
    check(percuss_builder_model(handle_.get(), &handle));
    return Model(handle);
  }

 private:
  detail::Owner<percuss_builder, percuss_builder_free> handle_;
};

/// Quantities of a suspension over its travel, one row per value of the variable.
class Kinematics {
 public:
  /// A column; the texts are valid as long as this object, missing is null if a row has a value.
  using Column = percuss_column;

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] const std::vector<Column> &columns() const noexcept { return columns_; }
  /// The number of the column of this name, such as camber or toe_left.
  [[nodiscard]] std::size_t find_column(std::string_view name) const {
    for (std::size_t i = 0; i < columns_.size(); i++) {
      if (columns_[i].name == name) return i;
    }
    throw Error(PERCUSS_ERROR_NAME, "no column is named " + std::string(name));
  }
  /// SI units; NaN for a missing value.
  [[nodiscard]] double operator()(std::size_t row, std::size_t column) const { return values_.at(row * columns_.size() + column); }
  /// The reason why a row has no pose; null for a row with a pose.
  [[nodiscard]] const char *problem(std::size_t row) const {
    const char *problem = nullptr;
    check(percuss_kinematics_problem(handle_.get(), row, &problem));
    return problem;
  }

 private:
  friend class Suspension;
  explicit Kinematics(percuss_kinematics *handle) : handle_(handle) {
    std::size_t columns = 0;
    check(percuss_kinematics_counts(handle, &rows_, &columns));
    columns_.resize(columns);
    for (std::size_t i = 0; i < columns; i++) check(percuss_kinematics_column(handle, i, &columns_[i]));
    values_.resize(rows_ * columns);
    check(percuss_kinematics_values(handle, values_.data(), values_.size()));
  }
  detail::Owner<percuss_kinematics, percuss_kinematics_free> handle_;
  std::size_t rows_ = 0;
  std::vector<Column> columns_;
  std::vector<double> values_;
};

/// A suspension read from its sheet of hardpoints.
class Suspension {
 public:
  /// Reads a sheet, a table or a JSON file.
  [[nodiscard]] static Suspension load_file(const std::string &path) {
    percuss_suspension *handle = nullptr;
    check(percuss_suspension_load_file(path.c_str(), &handle));
    return Suspension(handle);
  }
  /// Reads text; the ending of name determines the format.
  [[nodiscard]] static Suspension load_text(std::string_view text, const std::string &name = "sheet.toml") {
    percuss_suspension *handle = nullptr;
    check(percuss_suspension_load_memory(name.c_str(), text.data(), text.size(), &handle));
    return Suspension(handle);
  }
  /// The mechanism, with its named contacts.
  [[nodiscard]] Model model() const {
    percuss_model *handle = nullptr;
    check(percuss_suspension_model(get(), &handle));
    return Model(handle);
  }
  /// Data of a vehicle of which nothing is known.
  [[nodiscard]] static percuss_vehicle unknown_vehicle() {
    percuss_vehicle vehicle;
    check(percuss_vehicle_init(&vehicle));
    return vehicle;
  }
  /// Quantities at values (m) of a variable, PERCUSS_WHEEL_TRAVEL, PERCUSS_HEAVE, PERCUSS_ROLL or PERCUSS_STEER.
  Kinematics kinematics(percuss_wheel_motion variable, const std::vector<double> &values,
                        const percuss_vehicle &vehicle = unknown_vehicle()) const {
    percuss_kinematics *handle = nullptr;
    check(percuss_suspension_kinematics(get(), variable, values.data(), values.size(), &vehicle, &handle));
    return Kinematics(handle);
  }
  const percuss_suspension *get() const noexcept { return handle_.get(); }

 private:
  explicit Suspension(percuss_suspension *handle) : handle_(handle) {}
  detail::Owner<percuss_suspension, percuss_suspension_free> handle_;
};

/// The base, locks, armatures and held contacts of an analysis. Setters return the object itself. Setters of a
/// temporary object return a new object by move, so that `auto &&c = Conditions().lock("j")` does not dangle.
class Conditions {
 public:
  Conditions() {
    percuss_conditions *handle = nullptr;
    check(percuss_conditions_new(&handle));
    handle_.reset(handle);
  }
  /// Frees the root link.
  Conditions &floating_base() & {
    check(percuss_conditions_base(get(), PERCUSS_BASE_FLOATING));
    return *this;
  }
  Conditions floating_base() && {
    floating_base();
    return std::move(*this);
  }
  Conditions &lock(const std::string &joint) & {
    check(percuss_conditions_lock(get(), joint.c_str()));
    return *this;
  }
  Conditions lock(const std::string &joint) && {
    lock(joint);
    return std::move(*this);
  }
  /// Armature in kg·m² or kg: one value, or one for each velocity of the joint.
  Conditions &armature(const std::string &joint, const std::vector<double> &values) & {
    check(percuss_conditions_armature(get(), joint.c_str(), values.data(), values.size()));
    return *this;
  }
  Conditions armature(const std::string &joint, const std::vector<double> &values) && {
    armature(joint, values);
    return std::move(*this);
  }
  /// Holds a point (m, link's frame) to the ground, along a normal (root link's axes) or in all directions.
  Conditions &hold(const std::string &link, const Vector3 &point, std::optional<Vector3> normal = std::nullopt) & {
    check(percuss_conditions_hold(get(), link.c_str(), point.data(), normal ? normal->data() : nullptr));
    return *this;
  }
  Conditions hold(const std::string &link, const Vector3 &point, std::optional<Vector3> normal = std::nullopt) && {
    hold(link, point, normal);
    return std::move(*this);
  }
  percuss_conditions *get() const noexcept { return handle_.get(); }

 private:
  detail::Owner<percuss_conditions, percuss_conditions_free> handle_;
};

/// Positions of the joints. Setters follow the rules of Conditions.
class Configuration {
 public:
  explicit Configuration(const Model &model) {
    percuss_configuration *handle = nullptr;
    check(percuss_configuration_new(model.get(), &handle));
    handle_.reset(handle);
  }
  /// Sets a driving joint (rad or m; the layouts of percuss_joint_kind).
  Configuration &set(const std::string &joint, const std::vector<double> &values) & {
    check(percuss_configuration_set(get(), joint.c_str(), values.data(), values.size()));
    return *this;
  }
  Configuration set(const std::string &joint, const std::vector<double> &values) && {
    set(joint, values);
    return std::move(*this);
  }
  Configuration &set(const std::string &joint, double value) & {
    check(percuss_configuration_set(get(), joint.c_str(), &value, 1));
    return *this;
  }
  Configuration set(const std::string &joint, double value) && {
    set(joint, value);
    return std::move(*this);
  }
  /// Sets the initial position in the search for a dependent joint of a loop.
  Configuration &guess(const std::string &joint, const std::vector<double> &values) & {
    check(percuss_configuration_guess(get(), joint.c_str(), values.data(), values.size()));
    return *this;
  }
  Configuration guess(const std::string &joint, const std::vector<double> &values) && {
    guess(joint, values);
    return std::move(*this);
  }
  /// The positions of all joints, in joint order.
  Configuration &set_positions(const std::vector<double> &positions) & {
    check(percuss_configuration_set_positions(get(), positions.data(), positions.size()));
    return *this;
  }
  Configuration set_positions(const std::vector<double> &positions) && {
    set_positions(positions);
    return std::move(*this);
  }
  /// Sets the pose of the root link in the world: m, and a unit quaternion w, x, y, z.
  Configuration &set_base(const Vector3 &position, const std::array<double, 4> &quaternion) & {
    check(percuss_configuration_set_base(get(), position.data(), quaternion.data()));
    return *this;
  }
  Configuration set_base(const Vector3 &position, const std::array<double, 4> &quaternion) && {
    set_base(position, quaternion);
    return std::move(*this);
  }
  /// Resets every joint to zero.
  Configuration &reset() & {
    check(percuss_configuration_reset(get()));
    return *this;
  }
  Configuration reset() && {
    reset();
    return std::move(*this);
  }
  /// Accepts a pose on another assembly mode, beyond the reach of the branch of the first closed pose.
  Configuration &allow_other_assembly() & {
    check(percuss_configuration_allow_other_assembly(get()));
    return *this;
  }
  Configuration allow_other_assembly() && {
    allow_other_assembly();
    return std::move(*this);
  }
  percuss_configuration *get() const noexcept { return handle_.get(); }

 private:
  detail::Owner<percuss_configuration, percuss_configuration_free> handle_;
};

/// The full response to a contact.
class Response {
 public:
  [[nodiscard]] Mass mass() const {
    Mass mass;
    check(percuss_response_mass(get(), &mass));
    return mass;
  }
  /// m̄ and its error with a free mass (kg) as the other side.
  [[nodiscard]] Mass against_mass(double other) const {
    Mass mass;
    check(percuss_response_against_mass(get(), other, &mass));
    return mass;
  }
  /// v*: the velocities of all joints at unit closing speed, in joint order.
  [[nodiscard]] std::vector<double> velocities() const {
    std::vector<double> all(counts_.velocities);
    check(percuss_response_velocities(get(), all.data(), all.size()));
    return all;
  }
  /// v* of a floating root link: angular, then linear, in its axes.
  [[nodiscard]] std::array<double, 6> base_velocity() const {
    std::array<double, 6> twist{};
    check(percuss_response_base_velocity(get(), twist.data()));
    return twist;
  }
  /// Contributions of each link and of the rotor of each joint: their sum is 1.
  struct Contributions {
    std::vector<double> links, rotors;
  };
  [[nodiscard]] Contributions contributions() const {
    Contributions all{std::vector<double>(counts_.links), std::vector<double>(counts_.joints)};
    check(percuss_response_contributions(get(), all.links.data(), all.links.size(), all.rotors.data(),
                                         all.rotors.size()));
    return all;
  }
  const percuss_response *get() const noexcept { return handle_.get(); }

 private:
  friend class Pose;
  Response(percuss_response *handle, Model::Counts counts) : handle_(handle), counts_(counts) {}
  detail::Owner<percuss_response, percuss_response_free> handle_;
  Model::Counts counts_;
};

/// A matrix, column by column.
struct Matrix {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;
  [[nodiscard]] double operator()(std::size_t r, std::size_t c) const { return values[c * rows + r]; }
  /// The matrix in the form of percuss_effective_mass.
  [[nodiscard]] percuss_matrix view() const {
    return {values.data(), values.size(), rows, columns, rows, PERCUSS_COLUMN_MAJOR, 0};
  }
};

/// A mechanism at one configuration with closed loops.
class Pose {
 public:
  [[nodiscard]] Mass effective_mass(const Contact &contact, percuss_route route = PERCUSS_ROUTE_AUTO) const {
    Mass mass;
    check(percuss_pose_effective_mass(get(), &contact, route, &mass));
    return mass;
  }
  [[nodiscard]] Response respond(const Contact &contact, percuss_route route = PERCUSS_ROUTE_AUTO) const {
    percuss_response *handle = nullptr;
    check(percuss_pose_respond(get(), &contact, route, &handle));
    return Response(handle, counts_);
  }
  /// The positions of all joints, in joint order.
  [[nodiscard]] std::vector<double> positions() const {
    std::vector<double> all(counts_.positions);
    check(percuss_pose_positions(get(), all.data(), all.size()));
    return all;
  }
  /// Notes and warnings of System::touch; their texts are valid as long as the pose.
  [[nodiscard]] std::vector<percuss_diagnostic> diagnostics() const {
    std::size_t count = 0;
    check(percuss_pose_diagnostic_count(get(), &count));
    std::vector<percuss_diagnostic> all(count);
    for (std::size_t i = 0; i < count; i++) check(percuss_pose_diagnostic(get(), i, &all[i]));
    return all;
  }
  /// The pose at a configuration, followed along the branch of this pose.
  [[nodiscard]] Pose follow(const Configuration &configuration) const {
    percuss_pose *handle = nullptr;
    check(percuss_pose_follow(get(), configuration.get(), &handle));
    return Pose(handle, counts_, coordinates_);
  }
  /// M, n×n.
  [[nodiscard]] Matrix mass_matrix() const {
    Matrix m{coordinates_, coordinates_, std::vector<double>(coordinates_ * coordinates_)};
    check(percuss_pose_mass_matrix(get(), m.values.data(), m.values.size(), PERCUSS_COLUMN_MAJOR, m.rows));
    return m;
  }
  /// A, rows×n.
  [[nodiscard]] Matrix constraint_matrix() const {
    std::size_t rows = 0;
    check(percuss_pose_constraint_rows(get(), &rows));
    Matrix a{rows, coordinates_, std::vector<double>(rows * coordinates_)};
    check(percuss_pose_constraint_matrix(get(), a.values.data(), a.values.size(), PERCUSS_COLUMN_MAJOR, rows));
    return a;
  }
  /// j, n numbers.
  [[nodiscard]] std::vector<double> contact_row(const Contact &contact) const {
    std::vector<double> row(coordinates_);
    check(percuss_pose_contact_row(get(), &contact, row.data(), row.size()));
    return row;
  }
  struct Frame {
    /// Row by row.
    std::array<double, 9> rotation;
    /// m.
    std::array<double, 3> origin;
  };
  /// Frame of a link in the world.
  [[nodiscard]] Frame link_frame(std::size_t link) const {
    Frame frame{};
    check(percuss_pose_link_frame(get(), link, frame.rotation.data(), frame.origin.data()));
    return frame;
  }
  /// Gradient of m̄ by the velocities of all joints, kg/rad or kg/m; NaN unless m̄ is finite with an error of at most 1e-6 m̄.
  [[nodiscard]] std::vector<double> gradient(const Contact &contact) const {
    std::vector<double> all(counts_.velocities);
    check(percuss_pose_gradient(get(), &contact, all.data(), all.size(), nullptr, nullptr));
    return all;
  }
  /// Φ of the contact link at the contact point: 6×6, row by row, root axes, angular part first.
  [[nodiscard]] std::array<double, 36> inverse_inertia(const Contact &contact) const {
    std::array<double, 36> values{};
    check(percuss_pose_inverse_inertia(get(), &contact, values.data()));
    return values;
  }
  /// Degrees of freedom, rank, findings and closing of the loops.
  [[nodiscard]] percuss_pose_state state() const {
    percuss_pose_state state{};
    check(percuss_pose_describe(get(), &state));
    return state;
  }
  /// Results of many contacts.
  struct ContactMap {
    std::vector<percuss_outcome> outcomes;
    /// kg; NaN unless finite.
    std::vector<double> effective_masses, errors;
  };
  /// m̄ of many contacts of a link: points (m) and normals, 3 numbers each, one contact after another, in the link's frame.
  ContactMap contact_map(std::size_t link, const std::vector<double> &points, const std::vector<double> &normals,
                         std::size_t against = PERCUSS_GROUND) const {
    if (points.size() != normals.size() || points.size() % 3 != 0) {
      throw Error(PERCUSS_ERROR_LENGTH, "points and normals: expected 3 numbers for each contact");
    }
    const std::size_t count = points.size() / 3;
    ContactMap map{std::vector<percuss_outcome>(count), std::vector<double>(count), std::vector<double>(count)};
    check(percuss_pose_contact_map(get(), link, against, points.data(), normals.data(), count, map.outcomes.data(),
                                   map.effective_masses.data(), map.errors.data()));
    return map;
  }
  const percuss_pose *get() const noexcept { return handle_.get(); }

 private:
  friend class System;
  friend class Assembly;
  Pose(percuss_pose *handle, Model::Counts counts, std::size_t coordinates)
      : handle_(handle), counts_(counts), coordinates_(coordinates) {}
  detail::Owner<percuss_pose, percuss_pose_free> handle_;
  Model::Counts counts_;
  std::size_t coordinates_;
};

class Batch;

/// Workspace for one configuration after another. One thread at a time.
class Workspace {
 public:
  /// m̄ in kg at the positions of all joints; empty unless finite. `outcome` and `remarks` (PERCUSS_REMARK_…) are outputs.
  std::optional<double> effective_mass(const double *positions, std::size_t count, const Contact &contact,
                                       percuss_outcome *outcome = nullptr, std::uint32_t *remarks = nullptr) {
    percuss_outcome found = PERCUSS_NO_ANSWER;
    double mass = 0.0;
    check(percuss_workspace_effective_mass(handle_.get(), positions, count, &contact, &found, &mass, remarks));
    if (outcome != nullptr) *outcome = found;
    return found == PERCUSS_FINITE ? std::optional<double>(mass) : std::nullopt;
  }
  std::optional<double> effective_mass(const std::vector<double> &positions, const Contact &contact,
                                       percuss_outcome *outcome = nullptr, std::uint32_t *remarks = nullptr) {
    return effective_mass(positions.data(), positions.size(), contact, outcome, remarks);
  }
  /// m̄ of another contact at the last positions.
  std::optional<double> effective_mass_again(const Contact &contact, percuss_outcome *outcome = nullptr,
                                             std::uint32_t *remarks = nullptr) {
    percuss_outcome found = PERCUSS_NO_ANSWER;
    double mass = 0.0;
    check(percuss_workspace_effective_mass_again(handle_.get(), &contact, &found, &mass, remarks));
    if (outcome != nullptr) *outcome = found;
    return found == PERCUSS_FINITE ? std::optional<double>(mass) : std::nullopt;
  }
  /// m̄, its error and v* at the positions of all joints, or at the last positions if they are empty; `velocities` has the
  /// velocities of all joints at unit closing speed. Allocates nothing after the first call if `velocities` has its size.
  percuss_workspace_response respond(const std::vector<double> &positions, const Contact &contact,
                                     std::vector<double> &velocities) {
    velocities.resize(velocity_count_);
    percuss_workspace_response response{};
    check(percuss_workspace_respond(handle_.get(), positions.empty() ? nullptr : positions.data(), positions.size(), &contact,
                                    &response, velocities.data(), velocities.size()));
    return response;
  }
  /// Sets the pose of the root link in the world (m, and a unit quaternion w, x, y, z), for normals in the world.
  void set_base(const Vector3 &position, const std::array<double, 4> &quaternion) {
    check(percuss_workspace_set_base(handle_.get(), position.data(), quaternion.data()));
  }
  /// One contact at many configurations, with the assembly and the base of this workspace. threads: 1: the calling
  /// thread alone; 0: one per processor of the machine.
  Batch batch(const Contact &contact, std::size_t threads = 0);
  percuss_workspace *get() const noexcept { return handle_.get(); }

 private:
  friend class Assembly;
  Workspace(percuss_workspace *handle, std::size_t positions, std::size_t velocities)
      : handle_(handle), positions_(positions), velocity_count_(velocities) {}
  detail::Owner<percuss_workspace, percuss_workspace_free> handle_;
  std::size_t positions_, velocity_count_;
};

/// One contact at many configurations.
class Batch {
 public:
  struct Answers {
    std::vector<percuss_outcome> outcomes;
    /// kg; NaN unless finite.
    std::vector<double> effective_masses;
    /// kg; NaN if not computed.
    std::vector<double> errors;
    /// PERCUSS_REMARK_… added together, with the reason for a row without an answer.
    std::vector<std::uint32_t> remarks;
  };
  /// Called periodically with the number of configurations done. False stops the work, and so does an exception, which
  /// `run` rethrows.
  using Watch = std::function<bool(std::size_t)>;

  /// m̄ at count configurations; positions holds the positions of all joints, one configuration after another.
  [[nodiscard]] Answers run(const std::vector<double> &positions, std::size_t count, const Watch &watch = {}) const {
    return run(positions.data(), positions.size(), PERCUSS_ROW_MAJOR, positions_, count, watch);
  }
  /// As percuss_batch_run.
  Answers run(const double *positions, std::size_t length, percuss_layout layout, std::size_t stride,
              std::size_t count, const Watch &watch = {}) const {
    Answers answers{std::vector<percuss_outcome>(count), std::vector<double>(count), std::vector<double>(count),
                    std::vector<std::uint32_t>(count)};
    Watching watching{&watch, nullptr};
    const percuss_status status =
        percuss_batch_run(handle_.get(), positions, length, layout, stride, count, answers.outcomes.data(),
                          answers.effective_masses.data(), answers.errors.data(), answers.remarks.data(),
                          watch ? &ask : nullptr, &watching);
    if (watching.thrown) std::rethrow_exception(watching.thrown);
    check(status);
    return answers;
  }
  struct Derivatives {
    std::vector<percuss_outcome> outcomes;
    /// kg; NaN unless finite.
    std::vector<double> effective_masses, errors;
    /// Gradients of m̄ by the velocities of all joints, row by row.
    std::vector<double> gradients;
    /// Φ of the contact link at the contact point, 36 numbers for each configuration; empty unless wanted.
    std::vector<double> inverse_inertias;
  };
  /// m̄, its gradient and Φ at count configurations, row by row, with a point and a normal for each (or 3 numbers for all, or both
  /// empty: those of the contact). As percuss_batch_derivatives.
  Derivatives derivatives(const std::vector<double> &positions, std::size_t count, const std::vector<double> &points = {},
                          const std::vector<double> &normals = {}, bool inverse_inertias = false) const {
    Derivatives found{std::vector<percuss_outcome>(count), std::vector<double>(count), std::vector<double>(count),
                      std::vector<double>(count * velocities_), std::vector<double>(inverse_inertias ? 36 * count : 0)};
    check(percuss_batch_derivatives(handle_.get(), positions.data(), positions.size(), PERCUSS_ROW_MAJOR, positions_, count,
                                    points.empty() ? nullptr : points.data(), points.size(),
                                    normals.empty() ? nullptr : normals.data(), normals.size(), found.outcomes.data(),
                                    found.effective_masses.data(), found.errors.data(), found.gradients.data(),
                                    inverse_inertias ? found.inverse_inertias.data() : nullptr));
    return found;
  }
  const percuss_batch *get() const noexcept { return handle_.get(); }

 private:
  friend class Assembly;
  friend class Workspace;
  struct Watching {
    const Watch *watch;
    std::exception_ptr thrown;
  };
  static std::int32_t ask(std::size_t done, void *user) noexcept {
    auto *watching = static_cast<Watching *>(user);
    try {
      return (*watching->watch)(done) ? 0 : 1;
    } catch (...) {
      watching->thrown = std::current_exception();
      return 1;
    }
  }
  Batch(percuss_batch *handle, std::size_t positions, std::size_t velocities)
      : handle_(handle), positions_(positions), velocities_(velocities) {}
  detail::Owner<percuss_batch, percuss_batch_free> handle_;
  std::size_t positions_, velocities_;
};

inline Batch Workspace::batch(const Contact &contact, std::size_t threads) {
  percuss_batch *handle = nullptr;
  check(percuss_workspace_batch(get(), &contact, threads, &handle));
  return Batch(handle, positions_, velocity_count_);
}

/// A system with assembled loops.
class Assembly {
 public:
  struct Mobility {
    std::size_t degrees_of_freedom, redundant_constraints;
  };
  [[nodiscard]] Mobility mobility() const {
    Mobility mobility{};
    check(percuss_assembly_mobility(get(), &mobility.degrees_of_freedom, &mobility.redundant_constraints));
    return mobility;
  }
  [[nodiscard]] Pose pose(const Configuration &configuration) const {
    percuss_pose *handle = nullptr;
    check(percuss_assembly_pose(get(), configuration.get(), &handle));
    return Pose(handle, counts_, coordinates_);
  }
  [[nodiscard]] Workspace workspace() const {
    percuss_workspace *handle = nullptr;
    check(percuss_workspace_new(get(), &handle));
    return Workspace(handle, counts_.positions, counts_.velocities);
  }
  /// threads: 1: the calling thread alone; 0: one per processor of the machine.
  [[nodiscard]] Batch batch(const Contact &contact, std::size_t threads = 0) const {
    percuss_batch *handle = nullptr;
    check(percuss_batch_new(get(), &contact, threads, &handle));
    return Batch(handle, counts_.positions, counts_.velocities);
  }
  const percuss_assembly *get() const noexcept { return handle_.get(); }

 private:
  friend class System;
  Assembly(percuss_assembly *handle, Model::Counts counts, std::size_t coordinates)
      : handle_(handle), counts_(counts), coordinates_(coordinates) {}
  detail::Owner<percuss_assembly, percuss_assembly_free> handle_;
  Model::Counts counts_;
  std::size_t coordinates_;
};

/// A mechanism under conditions.
class System {
 public:
  /// Fixed base, every joint free.
  explicit System(const Model &model) : System(model, nullptr) {}
  System(const Model &model, const Conditions &conditions) : System(model, conditions.get()) {}
  [[nodiscard]] std::size_t coordinates() const noexcept { return coordinates_; }
  /// Assembles the loops from all joints at 0.
  Assembly assemble() const { return assemble(nullptr); }
  /// Assembles the loops from guesses.
  Assembly assemble(const Configuration &guesses) const { return assemble(guesses.get()); }
  [[nodiscard]] Pose pose(const Configuration &configuration) const {
    percuss_pose *handle = nullptr;
    check(percuss_pose_new(get(), configuration.get(), &handle));
    return Pose(handle, counts_, coordinates_);
  }
  /// The pose at which a stop touches, with its contact in `contact`: the name of a contact, or JOINT:lower or JOINT:upper.
  [[nodiscard]] Pose touch(const Configuration &configuration, const std::string &stop, Contact &contact) const {
    percuss_pose *handle = nullptr;
    check(percuss_pose_touch(get(), configuration.get(), stop.c_str(), &handle, &contact));
    return Pose(handle, counts_, coordinates_);
  }
  const percuss_system *get() const noexcept { return handle_.get(); }

 private:
  System(const Model &model, const percuss_conditions *conditions) : counts_(model.counts()) {
    percuss_system *handle = nullptr;
    check(percuss_system_new(model.get(), conditions, &handle));
    handle_.reset(handle);
    check(percuss_system_coordinates(get(), &coordinates_));
  }
  [[nodiscard]] Assembly assemble(const percuss_configuration *guesses) const {
    percuss_assembly *handle = nullptr;
    check(percuss_assembly_new(get(), guesses, &handle));
    return Assembly(handle, counts_, coordinates_);
  }
  detail::Owner<percuss_system, percuss_system_free> handle_;
  Model::Counts counts_;
  std::size_t coordinates_ = 0;
};

/// Options for reading matrices: percuss_matrix_options.
struct MatrixOptions {
  /// Displacement per unit rate of each coordinate; empty: 1 for all.
  std::vector<double> lengths{};
  double rank_floor = PERCUSS_DEFAULT;
  double accuracy = 2.220446049250313e-16;
  /// Of M, A and j; PERCUSS_DEFAULT: accuracy.
  double accuracy_of_mass = PERCUSS_DEFAULT;
  double accuracy_of_constraints = PERCUSS_DEFAULT;
  double accuracy_of_contact_row = PERCUSS_DEFAULT;
  double row_noise = PERCUSS_DEFAULT;
};

/// Result for matrices of the caller.
struct MatrixResponse {
  Mass mass{};
  /// v*, n numbers.
  std::vector<double> velocities;
  percuss_rank rank{};
  /// 1 for each redundant row of A, else 0.
  std::vector<std::uint8_t> redundant_rows;
};

/// m̄ = min { vᵀMv : Av = 0, jv = 1 } from matrices of the caller, read in place; constraints may be null.
inline MatrixResponse effective_mass(const percuss_matrix &mass, const std::vector<double> &contact_row,
                                     const percuss_matrix *constraints = nullptr,
                                     const MatrixOptions &options = {}) {
  const percuss_matrix_options given{options.lengths.empty() ? nullptr : options.lengths.data(),
                                     options.lengths.size(),
                                     options.rank_floor,
                                     options.accuracy,
                                     options.accuracy_of_mass,
                                     options.accuracy_of_constraints,
                                     options.accuracy_of_contact_row,
                                     options.row_noise};
  MatrixResponse response;
  response.velocities.resize(contact_row.size());
  response.redundant_rows.resize(constraints == nullptr ? 0 : constraints->rows);
  check(percuss_effective_mass(&mass, contact_row.data(), contact_row.size(), constraints, &given, &response.mass,
                               response.velocities.data(), &response.rank, response.redundant_rows.data()));
  return response;
}

/// The number of a law.
inline percuss_law find_law(const std::string &name) {
  percuss_law law = 0;
  check(percuss_law_find(name.c_str(), &law));
  return law;
}

/// The damper of a law for a restitution; speed (m/s) if the law needs a speed.
inline Damper damper(percuss_law law, const Spring &spring, double restitution, double speed = 0.0,
                     percuss_separation separation = PERCUSS_FORCE_VANISHES) {
  Damper damper;
  check(percuss_law_damper(law, &spring, restitution, speed, separation, &damper));
  return damper;
}

inline double restitution(const Damper &damper, const Spring &spring, double speed) {
  double e = 0.0;
  check(percuss_damper_restitution(&damper, &spring, speed, &e));
  return e;
}

inline Impact impact(const Damper &damper, const Spring &spring, double speed) {
  Impact impact;
  check(percuss_damper_impact(&damper, &spring, speed, &impact));
  return impact;
}

}  // namespace percuss

#endif
