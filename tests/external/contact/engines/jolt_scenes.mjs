// Impacts in Jolt, by its build for JavaScript: one JSON request on the standard input, one answer on the standard output.
//
//   {"package": folder of jolt-physics, "parameters": {…}, "other": restitution of the wall or null, "step": s, "phases": […],
//    "speed": m/s, "ball": {mass, radius} or "pendulum": {mass, centre, offset, inertia, lever, radius, rotor,
//    "ball": optional {mass, radius, share}: a free ball in place of the wall, with its share of the speed} or "four_bar": {radius, point, struck, bodies: [{mass, inertia, centre, velocity, rate}, …], hinges: [[body, body or null, x, y], …]}}
//
// Answer: {"version", "impacts": [[e, penetration], …]}. The parameters are the struck body's and, unless "other" says otherwise,
// the wall's too.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const request = JSON.parse(readFileSync(0, "utf8"));
const { parameters, step, speed } = request;
const entry = `${request.package}/dist/jolt-physics.wasm-compat.js`;
const Jolt = await (await import(pathToFileURL(entry))).default();
const STILL = 0, MOVING = 1;
// Steps of free flight before the contact, and the steps that are waited for its end.
const FLIGHT = 2, LONGEST = 50;
const upright = () => new Jolt.Quat(0, 0, 0, 1);

function world() {
  const pairs = new Jolt.ObjectLayerPairFilterTable(2);
  pairs.EnableCollision(STILL, MOVING);
  if (request.pendulum?.ball) pairs.EnableCollision(MOVING, MOVING);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
  for (const layer of [STILL, MOVING]) layers.MapObjectToBroadPhaseLayer(layer, new Jolt.BroadPhaseLayer(layer));
  const settings = new Jolt.JoltSettings();
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
  const jolt = new Jolt.JoltInterface(settings);
  const system = jolt.GetPhysicsSystem();
  system.SetGravity(new Jolt.Vec3(0, 0, 0));
  const physics = system.GetPhysicsSettings();
  physics.mMinVelocityForRestitution = parameters.mMinVelocityForRestitution;
  if (parameters.mNumVelocitySteps) physics.mNumVelocitySteps = parameters.mNumVelocitySteps;
  system.SetPhysicsSettings(physics);
  return { jolt, system };
}

function dress(settings, restitution) {
  settings.mRestitution = restitution;
  settings.mFriction = parameters.mFriction;
  settings.mLinearDamping = parameters.mLinearDamping;
  settings.mAngularDamping = parameters.mAngularDamping;
  return settings;
}

/// Its surface is z = top.
function wall(system, top) {
  const box = new Jolt.BoxShape(new Jolt.Vec3(2, 2, 0.5));
  const settings = new Jolt.BodyCreationSettings(box, new Jolt.RVec3(0, 0, top - 0.5), upright(), Jolt.EMotionType_Static, STILL);
  const body = system.GetBodyInterface().CreateBody(dress(settings, request.other ?? parameters.mRestitution));
  system.GetBodyInterface().AddBody(body.GetID(), Jolt.EActivation_DontActivate);
  return body;
}

function moving(system, shape, position, mass, inertia) {
  const settings = new Jolt.BodyCreationSettings(shape, position, upright(), Jolt.EMotionType_Dynamic, MOVING);
  dress(settings, parameters.mRestitution);
  settings.mAllowSleeping = false;
  settings.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
  settings.mMassPropertiesOverride.mMass = mass;
  settings.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(new Jolt.Vec3(...inertia));
  const body = system.GetBodyInterface().CreateBody(settings);
  system.GetBodyInterface().AddBody(body.GetID(), Jolt.EActivation_Activate);
  return body;
}

function ball({ mass, radius }, phase) {
  const { jolt, system } = world();
  wall(system, 0);
  const height = radius + (FLIGHT + phase) * step * speed;
  const about = 0.4 * mass * radius * radius;
  const body = moving(system, new Jolt.SphereShape(radius), new Jolt.RVec3(0, 0, height), mass, [about, about, about]);
  system.GetBodyInterface().SetLinearVelocity(body.GetID(), new Jolt.Vec3(0, 0, -speed));
  return watch(jolt, () => body.GetLinearVelocity().GetZ(), () => radius - body.GetPosition().GetZ());
}

/// Built at angle 0 and turned a little about the hinge, so that the hinge is where it is with no error.
function pendulum({ mass, centre, offset, inertia, lever, radius, rotor, ball: other }, phase) {
  const { jolt, system } = world();
  // Far below where a ball is struck: the hinge is at rest with it.
  const stop = wall(system, other ? -10 : -radius);
  const own = (1 - (other?.share ?? 0)) * speed;
  const angle = ((FLIGHT + phase) * step * own) / lever;
  // The sphere at the lever, seen from the centre of mass that the body has its origin in.
  const beside = new Jolt.Vec3(lever - centre, 0, -offset);
  const sphere = new Jolt.RotatedTranslatedShapeSettings(beside, upright(), new Jolt.SphereShapeSettings(radius));
  const back = new Jolt.Vec3(centre - lever, 0, offset);
  const shape = new Jolt.OffsetCenterOfMassShapeSettings(back, sphere).Create().Get();
  const about = [inertia, inertia + rotor, inertia];
  const body = moving(system, shape, new Jolt.RVec3(centre, 0, offset), mass, about);
  const hinge = new Jolt.HingeConstraintSettings();
  hinge.mSpace = Jolt.EConstraintSpace_WorldSpace;
  for (const side of [1, 2]) {
    hinge[`mPoint${side}`] = new Jolt.RVec3(0, 0, 0);
    hinge[`mHingeAxis${side}`] = new Jolt.Vec3(0, -1, 0);
    hinge[`mNormalAxis${side}`] = new Jolt.Vec3(1, 0, 0);
  }
  system.AddConstraint(hinge.Create(stop, body));
  const bodies = system.GetBodyInterface();
  const turned = new Jolt.Quat(0, -Math.sin(angle / 2), 0, Math.cos(angle / 2));
  const [x, z] = [centre * Math.cos(angle) - offset * Math.sin(angle), centre * Math.sin(angle) + offset * Math.cos(angle)];
  const place = new Jolt.RVec3(x, 0, z);
  bodies.SetPositionAndRotation(body.GetID(), place, turned, Jolt.EActivation_Activate);
  const rate = -own / lever;
  bodies.SetAngularVelocity(body.GetID(), new Jolt.Vec3(0, -rate, 0));
  const along = new Jolt.Vec3(-rate * z, 0, rate * x);
  bodies.SetLinearVelocity(body.GetID(), along);
  const height = () => 2 * lever * Math.asin(-body.GetRotation().GetY());
  const tip = () => -body.GetAngularVelocity().GetY() * lever;
  if (!other) return watch(jolt, tip, () => -height());
  const below = -radius - other.radius - (FLIGHT + phase) * step * speed * other.share;
  const still = 0.4 * other.mass * other.radius * other.radius;
  const struck = moving(system, new Jolt.SphereShape(other.radius), new Jolt.RVec3(lever, 0, below), other.mass, [still, still, still]);
  bodies.SetLinearVelocity(struck.GetID(), new Jolt.Vec3(0, 0, speed * other.share));
  const overlap = () => struck.GetPosition().GetZ() + other.radius + radius - height();
  return watch(jolt, () => tip() - struck.GetLinearVelocity().GetZ(), overlap, true);
}

/// In the plane of x and z: what is drawn along y is along z, a turn about z is one about −y; the contact is at the origin.
function fourBar({ radius, point, struck, bodies, hinges }, phase) {
  const { jolt, system } = world();
  const stop = wall(system, -radius - (FLIGHT + phase) * step * speed);
  const at = (x, z) => new Jolt.RVec3(x - point[0], 0, z - point[1]);
  const made = bodies.map(({ mass, inertia, centre, velocity, rate }, i) => {
    const hit = i === struck;
    const away = [point[0] - centre[0], 0, point[1] - centre[1]];
    // A sphere that nothing touches stands for the others' shapes.
    const sphere = new Jolt.SphereShapeSettings(hit ? radius : 1e-3);
    const placed = new Jolt.RotatedTranslatedShapeSettings(new Jolt.Vec3(...(hit ? away : [0, 0, 0])), upright(), sphere);
    const back = new Jolt.Vec3(...(hit ? away.map((x) => -x) : [0, 0, 0]));
    const shape = new Jolt.OffsetCenterOfMassShapeSettings(back, placed).Create().Get();
    const body = moving(system, shape, at(...centre), mass, [inertia, inertia, inertia]);
    system.GetBodyInterface().SetLinearVelocity(body.GetID(), new Jolt.Vec3(velocity[0], 0, velocity[1]));
    system.GetBodyInterface().SetAngularVelocity(body.GetID(), new Jolt.Vec3(0, -rate, 0));
    return body;
  });
  for (const [a, b, x, z] of hinges) {
    const hinge = new Jolt.HingeConstraintSettings();
    hinge.mSpace = Jolt.EConstraintSpace_WorldSpace;
    for (const side of [1, 2]) {
      hinge[`mPoint${side}`] = at(x, z);
      hinge[`mHingeAxis${side}`] = new Jolt.Vec3(0, -1, 0);
      hinge[`mNormalAxis${side}`] = new Jolt.Vec3(1, 0, 0);
    }
    system.AddConstraint(hinge.Create(b === null ? stop : made[b], made[a]));
  }
  const body = made[struck], { centre } = bodies[struck];
  const [x, z] = [point[0] - centre[0], point[1] - centre[1]];
  const turned = () => -2 * Math.asin(body.GetRotation().GetY());
  const across = () => x * Math.cos(turned()) - z * Math.sin(turned());
  const along = () => x * Math.sin(turned()) + z * Math.cos(turned());
  const opening = () => body.GetLinearVelocity().GetZ() - body.GetAngularVelocity().GetY() * across();
  const top = -(FLIGHT + phase) * step * speed;
  return watch(jolt, opening, () => top - (body.GetCenterOfMassPosition().GetZ() + along()), true);
}

/// `changes`: the speed changes as the mechanism moves on; it is that just after the impact.
function watch(jolt, opening, penetration, changes = false) {
  let depth = 0;
  for (let i = 0; i < LONGEST; i++) {
    jolt.Step(step, 1);
    depth = Math.max(depth, penetration());
    if (changes && opening() > -0.5 * speed) break;
  }
  const result = [opening() / speed, depth];
  Jolt.destroy(jolt);
  return result;
}

const scenes = { ball, pendulum, four_bar: fourBar };
const [name] = Object.keys(scenes).filter((scene) => request[scene]);
const one = (phase) => scenes[name](request[name], phase);
const { version } = JSON.parse(readFileSync(`${request.package}/package.json`, "utf8"));
console.log(JSON.stringify({ version, impacts: request.phases.map(one) }));
