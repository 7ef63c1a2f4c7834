//! What loading costs beside `urdf_rs::read_from_string` alone, on a chain of 1,000 links with shapes:
//! `cargo run --release -p percuss-formats --example load_time`. Says the ratio; the absolute times are this machine's.

use percuss_formats::{LoadOptions, Source, load};
use std::fmt::Write;
use std::hint::black_box;
use std::time::{Duration, Instant};

const LINKS: usize = 1_000;
const ROUNDS: usize = 15;

fn chain() -> String {
    let mut text = String::from("<robot name=\"chain\">\n");
    for i in 0..LINKS {
        let x = 0.1 + i as f64 / 7.0;
        let _ = write!(
            text,
            "<link name=\"l{i}\">\n  <inertial>\n    <origin xyz=\"{x} 0.0123 -0.25\" rpy=\"0.1 {x} 0\"/>\n    \
             <mass value=\"{x}\"/>\n    <inertia ixx=\"{x}\" ixy=\"0.001\" ixz=\"0\" iyy=\"{x}\" iyz=\"0\" \
             izz=\"{x}\"/>\n  </inertial>\n  <visual>\n    <origin xyz=\"0 0 0.1\" rpy=\"0 0 0\"/>\n    <geometry>\n      \
             <box size=\"0.1 0.1 {x}\"/>\n    </geometry>\n    <material name=\"grey\"/>\n  </visual>\n  <collision>\n    \
             <origin xyz=\"0 0 0.1\" rpy=\"0 0 0\"/>\n    <geometry>\n      <cylinder radius=\"0.05\" \
             length=\"{x}\"/>\n    </geometry>\n  </collision>\n</link>\n"
        );
        if i > 0 {
            let _ = write!(
                text,
                "<joint name=\"j{i}\" type=\"revolute\">\n  <origin xyz=\"0 0 {x}\" rpy=\"0 0.2 {x}\"/>\n  \
                 <parent link=\"l{}\"/>\n  <child link=\"l{i}\"/>\n  <axis xyz=\"0 0 1\"/>\n  \
                 <limit lower=\"-1.5\" upper=\"{x}\" effort=\"10\" velocity=\"3\"/>\n  \
                 <dynamics damping=\"0.1\" friction=\"0\"/>\n</joint>\n",
                i - 1
            );
        }
    }
    text.push_str("</robot>\n");
    text
}

fn fastest(mut work: impl FnMut()) -> Duration {
    let once = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..ROUNDS).map(|_| once(&mut work)).min().unwrap_or_default()
}

fn main() {
    let text = chain();
    let source = Source::from_text("chain.urdf", text.clone());
    let options = LoadOptions::default();
    let loaded = load(&source, &options).map(|l| l.mechanism.links().len());
    assert!(matches!(loaded, Ok(LINKS)), "{loaded:?}");
    let ours = fastest(|| drop(black_box(load(black_box(&source), &options))));
    let theirs = fastest(|| drop(black_box(urdf_rs::read_from_string(black_box(&text)))));
    println!("{} links, {} kB", LINKS, text.len() / 1000);
    println!("percuss_formats::load       {ours:?}");
    println!("urdf_rs::read_from_string   {theirs:?}");
    println!("ratio                       {:.2}", ours.as_secs_f64() / theirs.as_secs_f64());
}
