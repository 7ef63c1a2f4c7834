// The C++ layer: objects own their handles, failures are exceptions.
#include <percuss.hpp>

#include "check.h"

#include <type_traits>

static_assert(!std::is_copy_constructible_v<percuss::Pose> && std::is_move_constructible_v<percuss::Pose>);

template <class Call>
static void throws(percuss_status status, const char *text, Call call) {
  try {
    call();
  } catch (const percuss::Error &error) {
    CHECK(error.status() == status);
    CHECK(strstr(error.what(), text) != nullptr);
    return;
  }
  CHECK(!"an exception");
}

static void pendulum() {
  using namespace percuss;
  const Model model = Model::load_text(PENDULUM);
  CHECK(model.counts().links == 2 && model.diagnostics().size() == 1 && model.joint(0).kind == PERCUSS_CONTINUOUS);
  CHECK(model.link_name(model.find_link("rod")) == std::string("rod") && model.find_joint("hinge") == 0);
  const Contact contact = model.contact("rod", {0, 0, -0.8}, {1, 0, 0});
  const System system(model);
  Pose pose = system.pose(Configuration(model).set("hinge", 0.4));
  const Mass mass = pose.effective_mass(contact);
  CHECK(mass.outcome == PERCUSS_FINITE && std::fabs(mass.effective_mass - 0.78125) <= mass.error);
  const Response response = pose.respond(contact, PERCUSS_ROUTE_DENSE);
  CHECK(near_to(response.velocities()[0], -1.25, 1e-14) && response.base_velocity()[3] == 0.0);
  CHECK(near_to(response.contributions().links[1], 1.0, 1e-14) && near_to(response.against_mass(1.0).effective_mass, 0.78125 / 1.78125, 1e-14));
  Pose moved = std::move(pose);
  CHECK(pose.get() == nullptr && moved.positions()[0] == 0.4);
  throws(PERCUSS_ERROR_NULL, "percuss_pose", [&] { (void)pose.effective_mass(contact); });
  throws(PERCUSS_ERROR_NAME, "rod", [&] { (void)model.find_link("rodd"); });
  throws(PERCUSS_ERROR_LOAD, "x.urdf:1", [] { (void)Model::load_text("<robot", "x.urdf"); });
  throws(PERCUSS_ERROR_LOAD, "missing.urdf", [] { (void)Model::load_file("missing.urdf"); });
  throws(PERCUSS_ERROR_CONDITIONS, "hing", [&] { System(model, Conditions().lock("hing")); });
  const System heavy(model, Conditions().armature("hinge", {0.32}));
  CHECK(near_to(heavy.pose(Configuration(model)).effective_mass(contact).effective_mass, 1.28125, 1e-14));
  const System held(model, Conditions().floating_base().hold("ground", {0, 0, 0}, Vector3{1, 0, 0}));
  CHECK(held.coordinates() == 7);
}

static void four_bar() {
  using namespace percuss;
  const Model model = Model::load_text(FOUR_BAR);
  const System system(model);
  const Assembly assembly = system.assemble(Configuration(model).guess("coupler_hinge", {0.0}));
  CHECK(assembly.mobility().degrees_of_freedom == 1 && assembly.mobility().redundant_constraints == 3);
  const Contact contact = model.contact("coupler", {0.35, 0.1, 0}, {0, 1, 0});
  Workspace workspace = assembly.workspace();
  const Batch batch = assembly.batch(contact, 1);
  std::vector<double> positions, expected;
  Pose pose = assembly.pose(Configuration(model));
  for (int i = 0; i < 10; i++) {
    pose = pose.follow(Configuration(model).set("crank_hinge", 0.03 * i));
    const std::vector<double> q = pose.positions();
    positions.insert(positions.end(), q.begin(), q.end());
    expected.push_back(pose.effective_mass(contact).effective_mass);
    CHECK(near_to(workspace.effective_mass(q, contact).value(), expected.back(), 1e-10));
    const Matrix m = pose.mass_matrix(), a = pose.constraint_matrix();
    const percuss_matrix rows = a.view();
    const MatrixResponse dense = effective_mass(m.view(), pose.contact_row(contact), &rows);
    CHECK(near_to(dense.mass.effective_mass, expected.back(), 1e-11) && dense.rank.rank == 2);
    CHECK(dense.redundant_rows.size() == 5 && m(0, 1) == m(1, 0));
  }
  const Batch::Answers answers = batch.run(positions, expected.size());
  for (std::size_t i = 0; i < expected.size(); i++) CHECK(near_to(answers.effective_masses[i], expected[i], 1e-10));
  std::vector<double> many;
  for (int i = 0; i < 4000; i++) many.insert(many.end(), positions.begin(), positions.end());
  throws(PERCUSS_ERROR_STOPPED, "stopped", [&] { (void)batch.run(many, 40000, [](std::size_t) { return false; }); });
  bool caught = false;
  try {
    (void)batch.run(many, 40000, [](std::size_t) -> bool { throw std::logic_error("mine"); });
  } catch (const std::logic_error &error) {
    caught = error.what() == std::string("mine");
  }
  CHECK(caught);
}

/* A chain on a temporary object returns an object, not a dangling reference. */
static_assert(std::is_same_v<decltype(std::declval<percuss::Configuration>().set("j", 0.0)), percuss::Configuration>);
static_assert(std::is_same_v<decltype(std::declval<percuss::Configuration &>().set("j", 0.0)), percuss::Configuration &>);
static_assert(std::is_same_v<decltype(std::declval<percuss::Conditions>().lock("j")), percuss::Conditions>);

static void rules() {
  using namespace percuss;
  const Model model = Model::load_text(FOUR_BAR);
  const System system(model);
  auto &&chained = Configuration(model).set("crank_hinge", 0.2).guess("coupler_hinge", {0.0});
  const Assembly assembly = system.assemble();
  const Contact contact = model.contact("coupler", {0.35, 0.1, 0}, {0, 1, 0});
  const Pose pose = assembly.pose(chained);
  Workspace workspace = assembly.workspace();
  const std::vector<double> closed = pose.positions();
  std::uint32_t remarks = 77;
  const double m = workspace.effective_mass(closed, contact, nullptr, &remarks).value();
  CHECK(near_to(m, pose.effective_mass(contact).effective_mass, 1e-10));
  /* The drawing is open. */
  CHECK(remarks == PERCUSS_REMARK_DRAWN_OPEN);
  CHECK(workspace.effective_mass_again(contact).value() == m);
  /* Input rules, with the status of each. */
  throws(PERCUSS_ERROR_LENGTH, "0 positions", [&] { workspace.effective_mass(std::vector<double>{}, contact); });
  throws(PERCUSS_ERROR_LENGTH, "2 positions", [&] { workspace.effective_mass({0.0, 0.0}, contact); });
  throws(PERCUSS_ERROR_ASSEMBLY, "is open by", [&] { workspace.effective_mass({closed[0] + 0.1, closed[1], closed[2]}, contact); });
  throws(PERCUSS_ERROR_ARGUMENT, "position 1", [&] { workspace.effective_mass({closed[0], NAN, closed[2]}, contact); });
  throws(PERCUSS_ERROR_CONTACT, "length", [&] { (void)pose.effective_mass(model.contact("coupler", {0, 0, 0}, {0, 0, 0})); });
  throws(PERCUSS_ERROR_CONTACT, "length", [&] { (void)assembly.batch(model.contact("coupler", {0, 0, 0}, {0, 0, 0})); });
  throws(PERCUSS_ERROR_CONTACT, "point", [&] { (void)pose.respond(model.contact("coupler", {NAN, 0, 0}, {0, 1, 0})); });
  throws(PERCUSS_ERROR_ARGUMENT, "quaternion", [&] { Configuration(model).set_base({0, 0, 0}, {2, 0, 0, 0}); });
  throws(PERCUSS_ERROR_ARGUMENT, "quaternion", [&] { workspace.set_base({0, 0, 0}, {0, 0, 0, 0}); });
  throws(PERCUSS_ERROR_CONDITIONS, "0 positions", [&] { Configuration(model).set_positions({}); });
  throws(PERCUSS_ERROR_LAW, "speed", [&] { damper(0, Spring{2.0, 1e5, 1.0}, 0.5, NAN); });
  const Batch batch = assembly.batch(contact, 1);
  const Batch::Answers answers = batch.run({closed[0] + 0.1, closed[1], closed[2]}, 1);
  CHECK(answers.outcomes[0] == PERCUSS_NO_ANSWER && answers.remarks[0] == PERCUSS_REMARK_OPEN_LOOPS);
  throws(PERCUSS_ERROR_LENGTH, "positions", [&] { (void)batch.run({}, 1); });
}

/* A batch of a workspace has the base of the workspace; the options of matrices have the defaults of percuss.h. */
static void workspaces_and_matrices() {
  using namespace percuss;
  const Model model = Model::load_text(PENDULUM);
  const System system(model, Conditions().floating_base());
  const Assembly assembly = system.assemble();
  Contact contact = model.contact("rod", {0.1, 0, -0.8}, {1, 0, 0});
  contact.normal_given = PERCUSS_NORMAL_WORLD;
  Workspace workspace = assembly.workspace();
  Batch batch = workspace.batch(contact, 1);
  Batch::Answers answers = batch.run({0.3}, 1);
  CHECK((answers.remarks[0] & PERCUSS_REMARK_BASE_NOT_GIVEN) != 0);
  const Vector3 place{5.0, 6.0, 7.0};
  const std::array<double, 4> turned{0.5, 0.5, -0.5, 0.5};
  workspace.set_base(place, turned);
  batch = workspace.batch(contact, 2);
  answers = batch.run({0.3, -0.4}, 2);
  const double angles[] = {0.3, -0.4};
  for (std::size_t row = 0; row < 2; row++) {
    CHECK((answers.remarks[row] & PERCUSS_REMARK_BASE_NOT_GIVEN) == 0);
    const Pose pose = assembly.pose(Configuration(model).set("hinge", angles[row]).set_base(place, turned));
    const Mass mass = pose.effective_mass(contact);
    CHECK(answers.outcomes[row] == mass.outcome);
    CHECK(mass.outcome != PERCUSS_FINITE || near_to(answers.effective_masses[row], mass.effective_mass, 1e-11));
  }
  throws(PERCUSS_ERROR_CONTACT, "length", [&] { workspace.batch(model.contact("rod", {0, 0, 0}, {0, 0, 0})); });
  throws(PERCUSS_ERROR_ARGUMENT, "threads", [&] { workspace.batch(contact, 5000); });

  percuss_matrix_options plain;
  check(percuss_matrix_options_init(&plain));
  const MatrixOptions own;
  CHECK(own.rank_floor == plain.rank_floor && own.accuracy == plain.accuracy && own.row_noise == plain.row_noise);
  CHECK(own.accuracy_of_mass == plain.accuracy_of_mass && own.accuracy_of_constraints == plain.accuracy_of_constraints);
  CHECK(own.accuracy_of_contact_row == plain.accuracy_of_contact_row);
  const double m[] = {1.0, 0.0, 0.0, 3.0}, a[] = {1e-15, 0.0};
  const percuss_matrix mass{m, 4, 2, 2, 2, PERCUSS_ROW_MAJOR, 0}, rows{a, 2, 1, 2, 2, PERCUSS_ROW_MAJOR, 0};
  CHECK(near_to(effective_mass(mass, {1.0, 1.0}, &rows).mass.effective_mass, 3.0, 1e-14));
  MatrixOptions options;
  options.row_noise = 1e-12;
  CHECK(near_to(effective_mass(mass, {1.0, 1.0}, &rows, options).mass.effective_mass, 0.75, 1e-14));
  options.accuracy_of_mass = 1e-6;
  CHECK(effective_mass(mass, {1.0, 1.0}, nullptr, options).mass.error > 1e-7);
}

static void laws() {
  using namespace percuss;
  const Spring spring{2.0, 1e5, 1.5};
  for (const char *name : {"kelvin-voigt", "hunt-crossley"}) {
    const Damper found = damper(find_law(name), spring, 0.3, 0.7);
    CHECK(near_to(restitution(found, spring, 0.7), 0.3, 1e-12));
    CHECK(near_to(impact(found, spring, 0.7).rebound_speed, 0.21, 1e-12));
  }
  throws(PERCUSS_ERROR_LAW, "restitution", [&] { damper(0, spring, 1.5); });
}

static void suspensions() {
  using namespace percuss;
  const Suspension suspension = Suspension::load_text(SWING_AXLE);
  const std::vector<double> travels{-0.1, 0.0, 0.1, 0.9};
  const Kinematics table = suspension.kinematics(PERCUSS_HEAVE, travels);
  const std::size_t camber = table.find_column("camber");
  CHECK(table.rows() == 4 && std::string(table.columns()[camber].unit) == "rad");
  for (std::size_t row = 0; row < 3; row++) {
    CHECK(table.problem(row) == nullptr && std::abs(table(row, camber) + std::asin(travels[row] / 0.5)) < 1e-12);
  }
  CHECK(table.problem(3) != nullptr && std::isnan(table(3, camber)));
  const Model model = suspension.model();
  CHECK(model.gap_as_drawn("spring") == 0.0);
  // The parts of a spring always touch.
  Contact spring;
  const System system(model);
  const Pose touch = system.touch(Configuration(model), "spring", spring);
  CHECK(touch.effective_mass(spring).outcome == PERCUSS_FINITE && spring.link == model.named_contact("spring").link);
  throws(PERCUSS_ERROR_NAME, "spring", [&] { (void)system.touch(Configuration(model), "sprng", spring); });
  throws(PERCUSS_ERROR_NAME, "chamber", [&] { (void)table.find_column("chamber"); });
  throws(PERCUSS_ERROR_ASSEMBLY, "no tie rod", [&] { suspension.kinematics(PERCUSS_STEER, travels); });
  percuss_vehicle vehicle = Suspension::unknown_vehicle();
  vehicle.wheelbase = -1.0;
  throws(PERCUSS_ERROR_ARGUMENT, "wheelbase", [&] { suspension.kinematics(PERCUSS_HEAVE, travels, vehicle); });
}

static void built() {
  using namespace percuss;
  ModelBuilder builder("pendulum");
  JointDescription hinge;
  hinge.name = "hinge";
  hinge.parent = "ground";
  hinge.child = "rod";
  hinge.kind = PERCUSS_CONTINUOUS;
  hinge.axis[0] = 0.0;
  hinge.axis[1] = 1.0;
  builder.massless_link("ground").link("rod", 2.0, {0, 0, -0.5}, {}).joint(hinge);
  const Model model = builder.model();
  const Pose pose = System(model).pose(Configuration(model));
  CHECK(near_to(pose.effective_mass(model.contact("rod", {0, 0, -0.8}, {1, 0, 0})).effective_mass, 0.78125, 1e-14));
  CHECK(pose.state().degrees_of_freedom == 1 && pose.state().remarks == 0);
  const Pose::ContactMap map = pose.contact_map(model.find_link("rod"), {0, 0, -0.8, 0, 0, -0.5}, {1, 0, 0, 0, 0, 1});
  CHECK(near_to(map.effective_masses[0], 0.78125, 1e-12) && map.outcomes[1] == PERCUSS_IMMOVABLE);
  throws(PERCUSS_ERROR_LENGTH, "3 numbers", [&] { pose.contact_map(1, {0, 0}, {1, 0}); });
  ClosureDescription pin;
  pin.name = "pin";
  pin.predecessor = "rod";
  pin.successor = "nothing";
  throws(PERCUSS_ERROR_LOAD, "nothing", [&] { (void)builder.closure(pin).model(); });
}

int main() {
  pendulum();
  built();
  four_bar();
  rules();
  workspaces_and_matrices();
  laws();
  suspensions();
  puts("C++");
  return 0;
}
