//! Variants of a mechanism whose poses and axes in the world are chosen first, then written relative to random frames by the rules of a
//! version of SDFormat. The reader finds the poses and axes again.

use super::{drawn_pose, find, link};
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use percuss_formats::{LoadOptions, MemoryFiles, Source, load};
use percuss_mechanism::Mechanism;
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};

/// Variants of each version and kind of joint.
const VARIANTS: u64 = 14;
/// Poses and axes, m: rounding of a chain of at most ten poses of about 1 m, and of rpy angles 1e-4 rad from their singularity.
const TOLERANCE: f64 = 1e-11;

type Pose = Isometry3<f64>;

fn random_pose(rng: &mut StdRng) -> Pose {
    let mut numbers = || Vector3::from_fn(|_, _| rng.random_range(-1.5..1.5));
    Isometry3::from_parts(Translation3::from(numbers()), UnitQuaternion::new(numbers()))
}

fn numbers(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(" ")
}

/// One of several texts.
fn choose<'t>(rng: &mut StdRng, texts: &[&'t str]) -> &'t str {
    texts[rng.random_range(0..texts.len())]
}

/// Joint with its place and axes in the world.
struct ExpectedJoint {
    name: String,
    kind: &'static str,
    place: Vector3<f64>,
    axes: Vec<Vector3<f64>>,
}

/// Model with the poses of its frames in the world, the model frame first.
struct Model {
    minor: u32,
    contents: String,
    frames: Vec<(String, Pose)>,
    joints: Vec<ExpectedJoint>,
}

impl Model {
    /// Two links with a joint of a kind between them, and from version 1.7 on a frame that is attached to the first link, and another that
    /// is attached to this frame. `letter`: before all names.
    fn new(rng: &mut StdRng, minor: u32, letter: &str, kind: &'static str) -> Self {
        let frames = vec![("__model__".to_owned(), random_pose(rng))];
        let mut model = Self { minor, contents: String::new(), frames, joints: Vec::new() };
        let [a, b, f, g] = ["a", "b", "f", "g"].map(|name| format!("{letter}{name}"));
        let of_first = link(&a, &model.add(rng, &a, 0));
        model.contents += &of_first;
        if minor >= 7 {
            for (name, attached) in [(&f, &a), (&g, &f)] {
                let pose = model.add(rng, name, model.frames.len() - 1);
                model.contents +=
                    &format!("<frame name=\"{name}\" attached_to=\"{attached}\">{pose}</frame>");
            }
        }
        let of_second = link(&b, &model.add(rng, &b, 0));
        model.contents += &of_second;
        model.add_joint(rng, &format!("{letter}j"), kind, &a, &b);
        model
    }

    /// Adds a frame at a random pose. Returns its pose for the file; `default`: number of its base without a name of another.
    fn add(&mut self, rng: &mut StdRng, name: &str, default: usize) -> String {
        let pose = random_pose(rng);
        let text = self.pose_text(rng, &pose, &self.frames[default].1);
        self.frames.push((name.to_owned(), pose));
        text
    }

    /// Frames that an attribute may name: the model frame from version 1.7 on.
    fn named(&self) -> &[(String, Pose)] {
        &self.frames[usize::from(self.minor < 7)..]
    }

    /// Element with a pose in the world, relative to a random frame or to the default.
    fn pose_text(&self, rng: &mut StdRng, pose: &Pose, default: &Pose) -> String {
        let named = self.named();
        let (attribute, base) = if self.minor > 4 && !named.is_empty() && rng.random_bool(0.6) {
            let (name, base) = &named[rng.random_range(0..named.len())];
            (format!("{}=\"{name}\"", if self.minor < 7 { "frame" } else { "relative_to" }), base)
        } else {
            (String::new(), default)
        };
        pose_element(rng, self.minor, &attribute, &(base.inverse() * pose))
    }

    /// Adds a joint between two frames, with a random place and random axes.
    fn add_joint(&mut self, rng: &mut StdRng, name: &str, kind: &'static str, parent: &str, child: &str) {
        let of_child = self.frames.iter().find(|(name, _)| name == child).expect("a frame").1;
        let pose = random_pose(rng);
        let place = self.pose_text(rng, &pose, &of_child);
        let first = random_pose(rng).rotation * Vector3::x();
        let second = first.cross(&(random_pose(rng).rotation * Vector3::y())).normalize();
        let axes = match kind {
            "ball" | "fixed" => Vec::new(),
            "universal" => vec![first, second],
            _ => vec![first],
        };
        let flag = if self.minor < 7 { choose(rng, &["", "true", "1", "false", "0"]) } else { "" };
        let is_in_model = matches!(flag, "true" | "1") || (flag.is_empty() && self.minor == 4);
        let named = self.named();
        let named =
            (self.minor > 4 && rng.random_bool(0.5)).then(|| &named[rng.random_range(0..named.len())]);
        let frame = match named {
            _ if is_in_model => &self.frames[0].1,
            Some((_, frame)) => frame,
            None => &pose,
        };
        let expressed = named.map_or_else(String::new, |(name, _)| format!(" expressed_in=\"{name}\""));
        let flag = match flag {
            "" => String::new(),
            flag => format!("<use_parent_model_frame>{flag}</use_parent_model_frame>"),
        };
        let mut text = format!("<parent>{parent}</parent><child>{child}</child>{place}");
        for (tag, axis) in ["axis", "axis2"].into_iter().zip(&axes) {
            let xyz = numbers(frame.inverse_transform_vector(axis).as_slice());
            text += &format!("<{tag}><xyz{expressed}>{xyz}</xyz>{flag}</{tag}>");
        }
        self.contents += &format!("<joint name=\"{name}\" type=\"{kind}\">{text}</joint>");
        self.joints.push(ExpectedJoint { name: name.to_owned(), kind, place: pose.translation.vector, axes });
    }

    /// Adds a model in this file or, with an `<include>`, from the file `arm.sdf`, whose text is returned; and a joint to its first link.
    fn add_model(&mut self, rng: &mut StdRng, kind: &'static str) -> String {
        let is_merged = self.minor >= 9 && rng.random_bool(0.3);
        let is_included = is_merged || self.minor == 4 || rng.random_bool(0.5);
        let minor = if is_included { rng.random_range(4..=11) } else { self.minor };
        let inner = Self::new(rng, minor, "n", kind);
        let placement = inner.placement(rng, self.minor.min(minor));
        let default = self.frames[0].1;
        let pose = |rng: &mut StdRng| {
            self.pose_text(rng, &placement.map_or(inner.frames[0].1, |frame| frame.1), &default)
        };
        let prefix = if is_merged { "" } else { "n::" };
        let mut file = String::new();
        if is_included {
            let merge = if is_merged { " merge=\"true\"" } else { "" };
            let name = if is_merged { "" } else { "<name>n</name>" };
            let placed = placement
                .map_or_else(String::new, |(name, _)| format!("<placement_frame>{name}</placement_frame>"));
            self.contents +=
                &format!("<include{merge}><uri>arm.sdf</uri>{name}{placed}{}</include>", pose(rng));
            // The pose of the <include> replaces that of the file.
            file = format!(
                "<sdf version=\"1.{minor}\"><model name=\"arm\"><pose>9 8 7 6 5 4</pose>{}</model></sdf>",
                inner.contents
            );
        } else {
            let placed =
                placement.map_or_else(String::new, |(name, _)| format!(" placement_frame=\"{name}\""));
            self.contents += &format!("<model name=\"n\"{placed}>{}{}</model>", pose(rng), inner.contents);
        }
        self.frames.extend(inner.frames[1..].iter().map(|(name, pose)| (format!("{prefix}{name}"), *pose)));
        self.joints.extend(
            inner
                .joints
                .into_iter()
                .map(|joint| ExpectedJoint { name: format!("{prefix}{}", joint.name), ..joint }),
        );
        self.add_joint(rng, "k", kind, "b", &format!("{prefix}na"));
        file
    }

    /// Frame that takes the pose of the model, in versions that have it.
    fn placement(&self, rng: &mut StdRng, minor: u32) -> Option<&(String, Pose)> {
        (minor >= 8 && rng.random_bool(0.4)).then(|| &self.frames[rng.random_range(1..self.frames.len())])
    }
}

/// `<pose>` in one of the spellings of a version.
fn pose_element(rng: &mut StdRng, minor: u32, attribute: &str, pose: &Pose) -> String {
    let xyz = numbers(pose.translation.vector.as_slice());
    let (roll, pitch, yaw) = pose.rotation.euler_angles();
    let rpy = [roll, pitch, yaw];
    let q = pose.rotation.coords;
    let (format, rotation) = match if minor >= 9 { rng.random_range(0..4) } else { 0 } {
        1 => ("degrees=\"true\"", numbers(&rpy.map(f64::to_degrees))),
        2 => ("degrees=\"1\" rotation_format=\"euler_rpy\"", numbers(&rpy.map(f64::to_degrees))),
        3 => ("rotation_format=\"quat_xyzw\"", numbers(&[q.x, q.y, q.z, q.w])),
        _ => ("", numbers(&rpy)),
    };
    format!("<pose {attribute} {format}>{xyz} {rotation}</pose>")
}

/// Largest deviation of a joint from its place and its axes, m or 1.
fn deviation(mechanism: &Mechanism, expected: &ExpectedJoint) -> f64 {
    let ExpectedJoint { name, kind, place, axes } = expected;
    let named = |name: &str| find(mechanism, name);
    let joints = match *kind {
        "universal" => vec![named(&format!("{name}/axis")), named(&format!("{name}/axis2"))],
        _ => vec![named(name)],
    };
    let mut worst: f64 = 0.0;
    for (at, joint) in joints.iter().enumerate() {
        let child = drawn_pose(mechanism, mechanism.link(joint.child()).name());
        let beside = child.translation - place;
        worst = worst.max(match *kind {
            "revolute" => beside.cross(&axes[0]).norm(),
            "ball" => beside.norm(),
            "universal" if at == 0 => beside.norm(),
            _ => 0.0,
        });
        if let Some(axis) = axes.get(at) {
            worst = worst.max((child.vector(joint.axis()) - axis).norm());
        }
    }
    worst
}

#[test]
fn poses_and_axes_of_every_version_are_found_again() {
    let mut count = 0;
    for minor in 4..=11 {
        for kind in ["revolute", "prismatic", "ball", "fixed", "universal"] {
            for seed in 0..VARIANTS {
                let rng = &mut StdRng::seed_from_u64(1000 * u64::from(minor) + seed);
                let mut model = Model::new(rng, minor, "", kind);
                let arm = if seed % 2 == 0 { model.add_model(rng, kind) } else { String::new() };
                let placement = model.placement(rng, minor);
                let placed =
                    placement.map_or_else(String::new, |(name, _)| format!(" placement_frame=\"{name}\""));
                let pose = placement.map_or(model.frames[0].1, |frame| frame.1);
                let pose = pose_element(rng, minor, "", &pose);
                let text = format!(
                    "<sdf version=\"1.{minor}\"><model name=\"m\"{placed}>{pose}{}</model></sdf>",
                    model.contents
                );
                let case = format!("{text}\n{arm}");
                let files = [("main.sdf", text), ("arm.sdf", arm)]
                    .map(|(name, text)| (name.to_owned(), text.into_bytes()));
                let source =
                    Source::read_from(&MemoryFiles::new(files).into(), "main.sdf", 1 << 20).expect("a file");
                let loaded =
                    load(&source, &LoadOptions::default()).unwrap_or_else(|error| panic!("{error}\n{case}"));
                for (name, pose) in &model.frames[1..] {
                    let found = drawn_pose(&loaded.mechanism, name);
                    let beside = (found.translation - pose.translation.vector).amax();
                    let turned = (found.rotation - pose.rotation.to_rotation_matrix().matrix()).amax();
                    assert!(beside.max(turned) < TOLERANCE, "{name}: {beside:e}, {turned:e}\n{case}");
                }
                for joint in &model.joints {
                    let deviation = deviation(&loaded.mechanism, joint);
                    assert!(deviation < TOLERANCE, "{}: {deviation:e}\n{case}", joint.name);
                }
                count += 1;
            }
        }
    }
    assert!(count >= 540, "{count} variants");
}
