//! Elements of a URDF for simulators: couplings of plugins, rotors of transmissions, and the notations of other parsers.

use crate::support::{load_text, told};
use percuss_formats::{LoadOptions, Loaded, Source, load};
use percuss_mechanism::{Accept, Severity};

/// Gripper of two fingers of 0.1 kg on hinges `ja` and `jb`, with further elements.
fn gripper(extra: &str) -> String {
    let finger = |name: &str, x: f64, sign: i32| {
        format!(
            "<link name=\"{name}\"><inertial><origin xyz=\"0 0 0.04\"/><mass value=\"0.1\"/>\
             <inertia ixx=\"5e-5\" iyy=\"5e-5\" izz=\"1e-5\" ixy=\"0\" ixz=\"0\" \
             iyz=\"0\"/></inertial></link>\n\
             <joint name=\"j{name}\" type=\"revolute\"><parent link=\"palm\"/><child \
             link=\"{name}\"/><origin xyz=\"{x} 0 0\"/>\
             <axis xyz=\"0 {sign} 0\"/><limit lower=\"-1\" upper=\"1\" effort=\"5\" \
             velocity=\"1\"/></joint>\n"
        )
    };
    let fingers = finger("a", 0.03, 1) + &finger("b", -0.03, -1);
    format!("<robot name=\"grip\"><link name=\"palm\"/>{fingers}{extra}</robot>")
}

fn loaded(extra: &str) -> Loaded {
    load_text(&gripper(extra)).unwrap_or_else(|error| panic!("{extra}: {error}"))
}

/// Messages of the warnings.
fn warnings(extra: &str) -> Vec<String> {
    let loaded = loaded(extra);
    let warnings = loaded.diagnostics.iter().filter(|d| d.severity == Severity::Warning);
    warnings.map(|d| format!("{} {}", d.element.as_deref().unwrap_or_default(), d.message)).collect()
}

/// Multiplier and offset by which `jb` follows `ja`.
fn mimic(extra: &str) -> Option<[f64; 2]> {
    let loaded = loaded(extra);
    let id = loaded.mechanism.find_joint("jb").expect("a joint");
    let mimic = loaded.mechanism.joint(id).mimic()?;
    assert_eq!(loaded.mechanism.joint(mimic.master).name(), "ja");
    Some([mimic.multiplier, mimic.offset])
}

/// `<mimic>` in the joint `jb`, by replacing its axis.
fn with_mimic(text: &str, attributes: &str) -> String {
    text.replace(
        "<axis xyz=\"0 -1 0\"/>",
        &format!("<axis xyz=\"0 -1 0\"/><mimic joint=\"ja\" {attributes}/>"),
    )
}

#[test]
fn plugins_that_join_links_are_named() {
    let plugin = |name: &str, file: &str, inside: &str| {
        format!("<plugin name=\"{name}\" filename=\"{file}\">{inside}</plugin>")
    };
    let ends = "<x_one>grip::a</x_one><x_two>grip::b</x_two>";
    let joining = [
        plugin(
            "p1",
            "gz-sim-detachable-joint-system",
            "<parent_link>a</parent_link><child_link>b</child_link>",
        ),
        plugin("gz::sim::systems::DetachableJoint", "p2", ""),
        plugin("closed_loop", "p3.so", ""),
        plugin("p4", "libgazebo_ros_link_attacher.so", "<link1>a</link1><link2>other</link2>"),
        plugin("p5", "libunknown.so", ends),
        plugin("p6", "libunknown.so", "<pair one=\"ja\" two=\"jb\"/>"),
        plugin("p7", "libmimic.so", "<follower>jb</follower>"),
        plugin("p8", "libfour_bar_linkage.so", "<joint>ja</joint>"),
    ];
    let harmless = [
        plugin("c", "libgazebo_ros_camera.so", "<cameraName>a</cameraName><frameName>b</frameName>"),
        plugin(
            "d",
            "libgazebo_ros_diff_drive.so",
            "<left_joint>ja</left_joint><right_joint>jb</right_joint>",
        ),
        plugin("s", "libgazebo_ros_joint_state_publisher.so", "<jointName>ja, jb</jointName>"),
        plugin("gazebo_ros2_control", "libgazebo_ros2_control.so", "<parameters>x.yaml</parameters>"),
        plugin("f", "libgazebo_ros_p3d.so", "<bodyName>a</bodyName><frameName>b</frameName>"),
        plugin("u", "libunknown.so", "<link>a</link><joint>ja</joint>"),
    ];
    let places = ["<gazebo>{}</gazebo>", "<gazebo reference=\"a\">{}</gazebo>"];
    for place in places {
        for plugin in &joining {
            let found = warnings(&place.replace("{}", plugin));
            let expected = plugin.split('"').nth(1).unwrap();
            assert!(found.iter().any(|message| message.contains(expected)), "{place} {plugin}: {found:?}");
        }
        for plugin in &harmless {
            assert_eq!(warnings(&place.replace("{}", plugin)), [""; 0], "{place} {plugin}");
        }
    }
    let sensor = format!("<gazebo reference=\"a\"><sensor>{}</sensor></gazebo>", joining[4]);
    assert_eq!(warnings(&sensor), [""; 0], "a plugin of a sensor");
    let weld = "<loop name=\"l\" type=\"fixed\"><predecessor link=\"a\"/><successor link=\"b\"/></loop>";
    assert_eq!(
        warnings(&format!("<gazebo>{}</gazebo>{weld}", joining[4])),
        [""; 0],
        "a loop joins the links"
    );

    // The same names in an SDF.
    for (plugin, is_joining) in joining.iter().map(|p| (p, true)).chain(harmless.iter().map(|p| (p, false))) {
        let link = |name: &str| format!("<link name=\"{name}\"><inertial><mass>1</mass></inertial></link>");
        let joint = |name: &str, child: &str| {
            format!(
                "<joint name=\"{name}\" \
                 type=\"revolute\"><parent>world</parent><child>{child}</child><axis/></joint>"
            )
        };
        let parts = [link("a"), link("b"), joint("ja", "a"), joint("jb", "b")].concat();
        let sdf = format!("<sdf version=\"1.7\"><model name=\"grip\">{parts}{plugin}</model></sdf>");
        let loaded = load_text(&sdf);
        assert_eq!(
            told(&loaded).iter().any(|d| d.code == "plugin"),
            is_joining,
            "{plugin}: {:?}",
            told(&loaded)
        );
    }
}

#[test]
fn mimics_of_simulators_are_read() {
    for (m, o) in [("1", "0"), ("-1.5", "0.25"), ("2e-1", "-1")] {
        let expected = Some([m.parse().unwrap(), o.parse().unwrap()]);
        let spellings = [
            format!(
                "<gazebo><plugin name=\"x\" \
                 filename=\"libroboticsgroup_gazebo_mimic_joint_plugin.so\"><joint>ja</joint>\
                 <mimicJoint>jb</mimicJoint><multiplier>{m}</multiplier><offset>{o}</offset></plugin></gazebo>"
            ),
            format!(
                "<gazebo reference=\"b\"><plugin name=\"mimic_b\" \
                 filename=\"y\"><joint>ja</joint><mimic_joint> jb </mimic_joint>\
                 <multiplier>{m}</multiplier><offset>{o}</offset></plugin></gazebo>"
            ),
            format!(
                "<ros2_control name=\"g\" type=\"system\"><joint name=\"jb\"><param \
                 name=\"mimic\">ja</param>\
                 <param name=\"multiplier\">{m}</param><param \
                 name=\"offset\">{o}</param></joint></ros2_control>"
            ),
            format!(
                "<gazebo reference=\"jb\"><mimic \
                 joint=\"ja\"><multiplier>{m}</multiplier><offset>{o}</offset></mimic></gazebo>"
            ),
            format!(
                "<gazebo reference=\"jb\"><axis><mimic joint=\"ja\" multiplier=\"{m}\" \
                 offset=\"{o}\"/></axis></gazebo>"
            ),
        ];
        for spelling in &spellings {
            assert_eq!(mimic(spelling), expected, "{spelling}");
            assert_eq!(warnings(spelling), [""; 0], "{spelling}");
            // The same relation in the joint: no message. Another one: a warning.
            let of = |attributes: &str| load_text(&with_mimic(&gripper(spelling), attributes));
            let same = of(&format!("multiplier=\"{m}\" offset=\"{o}\""));
            assert!(same.is_ok() && told(&same).iter().all(|d| d.code != "plugin"), "{:?}", told(&same));
            let other = of("multiplier=\"3\"");
            assert!(
                told(&other).iter().any(|d| d.severity == Severity::Warning && d.code == "plugin"),
                "{spelling}"
            );
        }
    }
    let sdf = "<gazebo reference=\"jb\"><mimic joint=\"ja\"><multiplier>2</multiplier><reference>0.5</reference></mimic></gazebo>";
    assert_eq!(mimic(sdf), Some([2.0, -1.0]));
    let param = |m: &str, leader: &str| {
        format!(
            "<ros2_control name=\"g\"><joint name=\"jb\"><param name=\"mimic\">{leader}</param><param \
             name=\"multiplier\">{m}</param>\
             </joint></ros2_control>"
        )
    };
    for (unclear, said) in [
        (param("two", "ja"), "no number"),
        (param("1", "jx"), "\"jx\" does not exist"),
        (
            param("1", "ja")
                + "<loop name=\"l\" type=\"spherical\"><predecessor link=\"a\"/><successor link=\"b\"/></loop>",
            "loops",
        ),
        (
            "<ros2_control name=\"g\"><joint name=\"jb\" mimic=\"true\"/></ros2_control>".to_owned(),
            "has no <mimic>",
        ),
    ] {
        let found = warnings(&unclear);
        assert!(found.len() == 1 && found[0].contains(said), "{unclear}: {found:?}");
        assert_eq!(mimic(&unclear), None, "{unclear}");
    }
}

/// Armature I·N² for every place and spelling.
/// A comment beside a value has no effect; within a value it makes the value no number.
#[test]
fn comments_beside_values_have_no_effect() {
    for value in ["2", "<!-- c -->2", "2<!-- c -->", "\n <!-- c -->\n 2\n", "<?p?>2<!-- c --> "] {
        let joint = value.replace('2', "ja");
        for extra in [
            format!(
                "<gazebo reference=\"jb\"><mimic><joint>{joint}</joint><multiplier>{value}</multiplier></mimic></gazebo>"
            ),
            format!(
                "<ros2_control name=\"c\"><joint name=\"jb\"><param name=\"mimic\">{joint}</param><param name=\"multiplier\">{value}</param>\
                 </joint></ros2_control>"
            ),
            format!(
                "<gazebo><plugin name=\"m\" filename=\"libmimic.so\"><joint>{joint}</joint><mimicJoint>jb</mimicJoint>\
                 <multiplier>{value}</multiplier></plugin></gazebo>"
            ),
        ] {
            assert_eq!(mimic(&extra), Some([2.0, 0.0]), "{extra}");
        }
        let armature = format!("<gazebo reference=\"jb\"><armature>{value}</armature></gazebo>");
        let loaded = loaded(&armature);
        let id = loaded.mechanism.find_joint("jb").expect("a joint");
        assert_eq!(loaded.mechanism.joint(id).armature(), [2.0], "{armature}");
    }
    let split =
        "<gazebo reference=\"jb\"><mimic joint=\"ja\"><multiplier>2<!-- c -->5</multiplier></mimic></gazebo>";
    assert!(mimic(split).is_none() && !warnings(split).is_empty());
    assert!(!warnings("<gazebo reference=\"a\"><kinematic><!-- c -->true</kinematic></gazebo>").is_empty());
}

#[test]
fn rotors_of_transmissions_are_armatures() {
    let armature = |extra: &str| {
        let loaded = loaded(extra);
        loaded.mechanism.joint(loaded.mechanism.find_joint("ja").expect("a joint")).armature().to_vec()
    };
    let transmission = |inside: &str| {
        format!("<transmission name=\"t\"><type>x/SimpleTransmission</type>{inside}</transmission>")
    };
    let joint = "<joint name=\"ja\"/>";
    for (inertia, ratio) in [(1e-5, 100.0), (2.5e-4, -7.5), (3.0, 1.0)] {
        for i in ["motorInertia", "motor_inertia", "rotorInertia", "rotor_inertia"] {
            for n in ["mechanicalReduction", "mechanical_reduction", "gearRatio", "gear_ratio"] {
                let (i, n) = (format!("<{i}>{inertia:e}</{i}>"), format!("<{n}> {ratio} </{n}>"));
                let places = [
                    transmission(&format!("{joint}<actuator name=\"m\">{i}{n}</actuator>")),
                    transmission(&format!("{joint}<actuator name=\"m\"/>{i}{n}")),
                    transmission(&format!("{joint}<actuator name=\"m\">{n}</actuator>{i}")),
                    transmission(&format!(
                        "<joint name=\"ja\">{n}</joint><actuator name=\"m\">{i}{n}</actuator>"
                    )),
                    format!(
                        "<ros2_control name=\"c\">{}</ros2_control>",
                        transmission(&format!("{joint}<actuator>{i}{n}</actuator>"))
                    ),
                ];
                for place in places {
                    assert_eq!(armature(&place), [inertia * ratio * ratio], "{place}");
                    assert_eq!(warnings(&place), [""; 0], "{place}");
                }
            }
        }
    }
    let rotor = "<actuator name=\"m\"><motorInertia>1</motorInertia><mechanicalReduction>3</mechanicalReduction></actuator>";
    assert_eq!(armature("<gazebo reference=\"ja\"><armature>0.25</armature></gazebo>"), [0.25]);
    let gear = loaded(&transmission(&format!(
        "{joint}<actuator name=\"m\"><mechanicalReduction>50</mechanicalReduction></actuator>"
    )));
    let note = gear.diagnostics.iter().find(|d| d.code == "gear-without-rotor").expect("a note");
    assert_eq!((note.severity, note.message.contains("I·N²")), (Severity::Note, true));
    for (unread, said) in [
        (transmission(&format!("<joint name=\"jx\"/>{rotor}")), "\"jx\""),
        (transmission(&format!("{joint}<joint name=\"jb\"/>{rotor}")), "one joint alone"),
        (transmission(&format!("{joint}{rotor}")).replace("Simple", "Differential"), "one joint alone"),
        (transmission(&format!("{joint}{rotor}")).replace("Simple", "FourBarLinkage"), "one joint alone"),
        (transmission(&format!("{joint}<actuatr/>")), "actuator"),
        (transmission(&format!("{joint}{}", rotor.replace(">3<", ">three<"))), "three"),
        (transmission(&format!("{joint}{}", rotor.replace(">1<", ">-1<"))), "-1"),
        (transmission(&format!("{joint}{rotor}{}", rotor.replace(">3<", ">4<"))), "3, 4"),
        ("<gazebo reference=\"jx\"><armature>1</armature></gazebo>".to_owned(), "armature"),
    ] {
        let found = warnings(&unread);
        assert!(found.len() == 1 && found[0].contains(said), "{unread}: {found:?}");
        assert_eq!(armature(&unread), [0.0; 1], "{unread}");
    }
    // Two motors, or two armatures, of a joint.
    let motor = |name: &str| {
        format!(
            "<actuator name=\"{name}\"><motorInertia>1e-5</motorInertia><mechanicalReduction>10</mechanicalReduction></actuator>"
        )
    };
    let transmission =
        |motors: &str| format!("<transmission name=\"t\"><joint name=\"ja\"/>{motors}</transmission>");
    assert!(warnings(&transmission(&motor("m"))).is_empty());
    assert!(warnings(&transmission(&(motor("m") + &motor("n"))))[0].contains("second motor"));
    let twice = "<gazebo reference=\"ja\"><armature>0.1</armature><armature>0.2</armature></gazebo>";
    assert!(warnings(twice)[0].contains("0.2"));
}

/// Notations that other parsers read: the same mechanism, with a note, and findings on the right lines.
#[test]
fn tolerated_notations_are_read_with_a_note() {
    let plain = gripper("<loop/>");
    let urdf = gripper("");
    let sdf = "<sdf version=\"1.7\"><model name=\"m\">\n<link name=\"a\"><inertial><mass>1</mass></inertial></link></model></sdf>";
    let mjcf = "<mujoco model=\"m\"><worldbody>\n<body name=\"a\"><joint type=\"hinge\"/><geom size=\"1\" mass=\"2\"/></body></worldbody></mujoco>";
    let declared = "<?xml version=\"1.0\"?>";
    for text in [&urdf, sdf, mjcf] {
        let expected = load_text(text).unwrap_or_else(|error| panic!("{error}"));
        let latin = format!("<!-- M\u{e4}rz -->{text}").chars().map(|c| c as u8).collect::<Vec<u8>>();
        let cases = [
            format!("\n {declared}{text}").into_bytes(),
            text.replace("\" type", "\"type")
                .replace("\" mass", "\"mass")
                .replace("version=\"1.7\"", "a=\"1\"version=\"1.7\"")
                .into_bytes(),
            latin.clone(),
            [b"<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>".to_vec(), latin].concat(),
        ];
        for bytes in cases {
            let shown = String::from_utf8_lossy(&bytes).into_owned();
            let found = load(&Source::new("model.xml", bytes), &LoadOptions::default());
            let found = found.unwrap_or_else(|error| panic!("{shown}: {error}"));
            assert_eq!(found.mechanism.total_mass(), expected.mechanism.total_mass(), "{shown}");
            assert!(
                found.diagnostics.iter().any(|d| ["xml-repaired", "windows-1252"].contains(&d.code)),
                "{shown}"
            );
        }
    }
    let line = |text: &str| {
        let error = load_text(text).err().unwrap_or_else(|| panic!("{text}"));
        error.diagnostics.iter().find(|d| d.severity == Severity::Error).and_then(|d| d.line)
    };
    let own = line(&plain).expect("a line");
    assert_eq!(line(&format!("\n\n{declared}{plain}")), Some(own + 2));
    assert_eq!(line(&plain.replace("ixx=\"5e-5\" iyy", "ixx=\"5e-5\"iyy")), Some(own));
    let declared_otherwise = b"<?xml version=\"1.0\" encoding=\"Shift_JIS\"?><!-- \x83 --><robot/>".to_vec();
    assert!(load(&Source::new("x", declared_otherwise), &LoadOptions::default()).is_err());
}

#[test]
fn faults_without_effect_are_warnings() {
    let with = |in_link: &str, in_joint: &str| {
        format!(
            "<link name=\"c\">{in_link}</link><joint name=\"f\" type=\"fixed\"><parent link=\"palm\"/><child \
             link=\"c\"/>{in_joint}</joint>"
        )
    };
    let fixed = |in_joint| with("", in_joint);
    let macros = "<visual><geometry><box size=\"1 1 1\"/></geometry><x:grey xmlns:x=\"http://www.ros.org/wiki/xacro\"/></visual>";
    for faulty in [
        fixed("<axis xzy=\"1 0 0\"/>"),
        fixed("<axis xyz=\"0 0\"/>"),
        fixed("<axis xyz=\"1 0 0\"/><axis xyz=\"0 1 0\"/>"),
        with(macros, ""),
    ] {
        assert!(!warnings(&faulty).is_empty(), "{faulty}");
    }
    assert_eq!(warnings(&fixed("<axis/>")).len(), 1);
    let unlimited =
        gripper("").replace("lower=\"-1\" upper=\"1\"", "lower=\"-1.79769e+308\" upper=\"1.8e308\"");
    let unlimited = load_text(&unlimited).unwrap_or_else(|error| panic!("{error}"));
    assert!(unlimited.mechanism.joints().iter().all(|joint| joint.limits().is_none()));
    let twice = gripper("").replacen("<inertial>", "<inertial><mass value=\"7\"/></inertial><inertial>", 1);
    let options = LoadOptions {
        accept: Accept { second_inertial: true, ..Accept::default() },
        ..LoadOptions::default()
    };
    let refused = load_text(&twice).expect_err("two inertials");
    assert!(refused.to_string().contains("--accept second-inertial"), "{refused}");
    let accepted = load(&Source::from_text("x", twice), &options).unwrap_or_else(|error| panic!("{error}"));
    assert!((accepted.mechanism.total_mass() - 7.1).abs() < 1e-12, "the first one counts");
    assert!(
        accepted.diagnostics.iter().any(|d| d.severity == Severity::Warning && d.code == "duplicate-element")
    );
}

/// A screw of the PR2 and a gearbox are relations of their joints.
#[test]
fn screws_and_gearboxes_are_relations() {
    let lift = "<robot name=\"r\"><link name=\"base\"/><link name=\"torso\"><inertial><mass value=\"1\"/></inertial></link>\
        <link name=\"nut\"><inertial><mass value=\"1\"/></inertial></link>\
        <joint name=\"lift\" type=\"prismatic\"><parent link=\"base\"/><child link=\"torso\"/><origin \
        rpy=\"0 0 1\"/><axis xyz=\"0 0 1\"/></joint>\
        <joint name=\"spin\" type=\"continuous\"><parent link=\"base\"/><child link=\"nut\"/><axis \
        xyz=\"0 0 -1\"/></joint>\
        <gazebo><joint name=\"screw\" \
        type=\"screw\"><parent>torso</parent><child>nut</child><axis><xyz>0 0 \
        1</xyz></axis>PITCH</joint></gazebo>\
        </robot>";
    let terms = |text: &str| {
        let loaded = load_text(text).unwrap_or_else(|error| panic!("{error}"));
        let [coupling] = loaded.mechanism.couplings() else { panic!("one relation") };
        let named = |(joint, factor): &(_, f64)| (loaded.mechanism.joint(*joint).name().to_owned(), *factor);
        coupling.terms().iter().map(named).collect::<Vec<_>>()
    };
    for (pitch, advance) in [
        ("<thread_pitch>3141.6</thread_pitch>", -1.0 / 3141.6),
        ("<screw_thread_pitch>0.002</screw_thread_pitch>", 0.002 / std::f64::consts::TAU),
    ] {
        let [(slide, along), (hinge, about)] = &terms(&lift.replace("PITCH", pitch))[..] else {
            panic!("two terms")
        };
        assert_eq!((slide.as_str(), hinge.as_str()), ("lift", "spin"));
        // The nut sinks against the torso by `lift`, and turns by −`spin`: −lift = −advance·spin.
        assert!((about / along + advance).abs() < 1e-15, "{along} {about}");
    }
    // Without a slide with its axis, the screw is a loop through a nut that turns on the torso and advances by 1/9 m/rad, left-handed.
    let other = lift.replace("PITCH", "<thread_pitch>9</thread_pitch>").replace("prismatic", "continuous");
    let screw = load_text(&other).unwrap_or_else(|error| panic!("{error}")).mechanism;
    let [turn, advance] =
        ["screw", "screw/advance"].map(|name| screw.joint(screw.find_joint(name).expect(name)));
    let ([loop_], Some(mimic)) = (screw.closures(), advance.mimic()) else { panic!("a loop and a mimic") };
    assert_eq!(screw.joint(mimic.master).name(), turn.name());
    assert!((mimic.multiplier + 1.0 / 9.0).abs() < 1e-15 && (turn.axis() - advance.axis()).norm() < 1e-15);
    let ends = [loop_.predecessor(), loop_.successor()].map(|end| end.link.expect("no end is the world"));
    let names = [turn.parent(), turn.child(), advance.parent(), ends[0], ends[1]];
    let names = names.map(|link| screw.link(link).name());
    assert_eq!(names, ["torso", "screw/nut", "screw/nut", "screw/advance", "nut"]);
    let gear = "<gazebo><joint name=\"g\" type=\"gearbox\"><parent>a</parent><child>b</child><gearbox_ratio>4</gearbox_ratio>\
        <gearbox_reference_body>palm</gearbox_reference_body><axis><xyz>0 1 0</xyz></axis><axis2><xyz>0 \
        1 0</xyz></axis2></joint></gazebo>";
    // θ_b = −4 θ_a about +y, and jb turns about −y.
    let [(first, a), (second, b)] = &terms(&gripper(gear))[..] else { panic!("two terms") };
    assert_eq!((first.as_str(), second.as_str(), a / b), ("ja", "jb", -4.0));
}

#[test]
fn files_of_other_formats_are_named() {
    for (file, text, kind) in [
        ("a.usda", "#usda 1.0\n", "USD"),
        ("a", "#usda 1.0\n", "USD"),
        ("a.usdc", "PXR-USDC\0\0", "USD"),
        ("a.usdz", "PK\x03\x04\0", "USD"),
        ("a.osim", "<?xml version=\"1.0\"?>\n<OpenSimDocument Version=\"3\">", "OpenSim"),
        ("a.rob", "### Metadata\nTParent 1", "Klampt"),
        ("a.LUA", "return {}", "RBDL"),
        ("a.yaml", "bodies: []", "YAML"),
        ("a.cmd", "model create", "Adams"),
        ("a.pm", "[BODY]", "rFactor"),
        ("a.m", "function a", "MATLAB"),
        ("a.xml", "<Robot name=\"a\"/>", "OpenRAVE"),
        ("a.py", "import os", "Python"),
    ] {
        let error =
            load(&Source::from_text(file, text), &LoadOptions::default()).expect_err(file).to_string();
        assert!(error.contains(kind) && error.contains("MJCF") && error.contains(".toml"), "{file}: {error}");
    }
    let urdf = load(&Source::from_text("a.m", gripper("")), &LoadOptions::default());
    assert!(urdf.is_ok(), "the content counts, not the ending");
}

/// Inertias and couplings of joints wherever a file states them and they are not read: a warning names each.
#[test]
fn values_of_joints_in_unread_parts_are_named() {
    let rotor = "<param name=\"motorInertia\">1e-5</param>";
    let transmission = |inside: &str| {
        format!("<transmission name=\"t\"><type>x/SimpleTransmission</type>{inside}</transmission>")
    };
    let control = |inside: &str| format!("<ros2_control name=\"c\" type=\"system\">{inside}</ros2_control>");
    let gazebo = |inside: &str| format!("<gazebo reference=\"ja\">{inside}</gazebo>");
    let plugin = |inside: &str| {
        format!("<gazebo><plugin name=\"finger_control\" filename=\"x.so\">{inside}</plugin></gazebo>")
    };
    let joint = "<joint name=\"ja\"/>";
    for (text, name) in [
        (transmission(&format!("{joint}<actuator name=\"m\">{rotor}</actuator>")), "motorInertia"),
        (transmission(&format!("{joint}<actuator name=\"m\"/>{rotor}")), "motorInertia"),
        (transmission(&format!("<joint name=\"ja\">{rotor}</joint><actuator name=\"m\"/>")), "motorInertia"),
        (gazebo("<dynamics armature=\"0.1\"/>"), "armature"),
        (gazebo("<physics><ode><armature>0.1</armature></ode></physics>"), "armature"),
        (gazebo("<physics><mimic joint=\"jb\"/></physics>"), "mimic"),
        (control("<joint name=\"jb\"><param name=\"rotor_inertia\">1e-5</param></joint>"), "rotor_inertia"),
        (control("<joint name=\"jb\"><param name=\"mimics\">ja</param></joint>"), "mimics"),
        (control("<joint name=\"jb\"><param name=\"follows\">ja</param></joint>"), "follows"),
        (
            control(
                "<joint name=\"jb\"><command_interface name=\"p\"><param name=\"mimic\">ja</param></command_interface></joint>",
            ),
            "mimic",
        ),
        (control("<hardware><param name=\"ja_armature\">0.1</param></hardware>"), "ja_armature"),
        (control("<joint name=\"jb\" mimic=\"1\"/>"), "mimic"),
        (plugin("<joint>ja</joint><rotorInertia>1e-5</rotorInertia>"), "rotorInertia"),
        (plugin("<joint>jb</joint><follower>ja</follower>"), "joins"),
        (plugin("<joint>jb</joint><multiplier>2</multiplier>"), "joins"),
        (plugin("").replace("finger_control", "belt_drive"), "joins"),
        (plugin("<pair>[ja;jb]</pair>").replace("finger_control", "x"), "joins"),
        ("<drake:weld xmlns:drake=\"http://drake.mit.edu\" a=\"b\"/>".to_owned(), "drake:weld"),
        ("<xi:include xmlns:xi=\"http://www.w3.org/2001/XInclude\" href=\"y\"/>".to_owned(), "include"),
    ] {
        let found = warnings(&text);
        assert!(found.iter().any(|message| message.contains(name)), "{text}: {found:?}");
    }
    // Each name at each place.
    for name in [
        "armature",
        "RotorInertia",
        "gear-inertia",
        "apparent_inertia",
        "rotor_mass",
        "added_mass",
        "payload",
    ] {
        for text in [
            gazebo(&format!("<dynamics {name}=\"0.5\"/>")),
            gazebo(&format!("<axis {name}=\"0.5\"/>")),
            gazebo(&format!("<axis><dynamics><{name}>0.5</{name}></dynamics></axis>")),
            gazebo("").replace("reference", &format!("xmlns:x=\"http://x\" x:{name}=\"0.5\" reference")),
            plugin(&format!("<joint><{name}>0.5</{name}></joint>")),
            plugin(&format!("<param name=\"{name}\" value=\"0.5\"/>")),
            plugin(&format!("<property key=\"{name}\">0.5</property>")),
            control(&format!("<joint name=\"jb\"><param name=\"{name}\">0.5</param></joint>")),
            control(&format!("<hardware><param name=\"{name}\">0.5</param></hardware>")),
            format!("<mujoco><custom><numeric name=\"{name}\" data=\"0.5\"/></custom></mujoco>"),
            format!(
                "<mujoco><extension><plugin plugin=\"p\"><config key=\"{name}\" value=\"0.5\"/></plugin></extension></mujoco>"
            ),
            format!("<x:info xmlns:x=\"http://x\"><{name}>0.5</{name}></x:info>"),
        ] {
            let found = warnings(&text);
            assert!(found.iter().any(|message| message.contains(name)), "{text}: {found:?}");
            assert_eq!(warnings(&text.replace("0.5", "0.0")), [""; 0], "{text}");
        }
    }
    // Without influence: no warning.
    for text in [
        gazebo("<dynamics armature=\"0\"/>"),
        plugin("<inertial_frame>map</inertial_frame>"),
        control("<joint name=\"jb\"><param name=\"min\">-1</param></joint>"),
        plugin("<joint>ja</joint><joint>jb</joint>"),
        "<x:weld xmlns:x=\"http://x\" a=\"b\"/>".to_owned(),
    ] {
        assert_eq!(warnings(&text), [""; 0], "{text}");
    }
    let drake = "<drake:rotor_inertia value=\"1e-5\"/><drake:gear_ratio value=\"100\"/>";
    for place in [
        transmission(&format!("{joint}<actuator name=\"m\"/>{drake}")),
        transmission(&format!("<joint name=\"ja\">{drake}</joint><actuator name=\"m\"/>")),
    ] {
        let loaded = loaded(&place);
        let id = loaded.mechanism.find_joint("ja").expect("a joint");
        assert!((loaded.mechanism.joint(id).armature()[0] - 0.1).abs() < 1e-15, "{place}");
    }
}

/// Angles of more than a turn are degrees, as a rule.
#[test]
fn angles_in_degrees_are_suspected() {
    let turned = |rpy: &str| {
        let text = gripper("").replacen(
            "<origin xyz=\"0.03 0 0\"/>",
            &format!("<origin xyz=\"0.03 0 0\" rpy=\"{rpy}\"/>"),
            1,
        );
        let loaded = load_text(&text).unwrap_or_else(|error| panic!("{error}"));
        loaded.diagnostics.iter().any(|d| d.code == "large-angle" && d.severity == Severity::Warning)
    };
    for (rpy, is_suspect) in [
        ("0 0 90", true),
        ("180 0 0", true),
        ("0 -45 0", true),
        ("0 6.2832 -6.2831853", false),
        ("1.5708 0 0", false),
    ] {
        assert_eq!(turned(rpy), is_suspect, "{rpy}");
    }
}
