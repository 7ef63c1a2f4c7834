use percuss_render::*;
fn main() {
    let s = |n: &str, style, points| Series { name: n.into(), style, points };
    let f = Figure { title: "Titel mit Ümlaut ΔE ≤ 質量 m̄ M̄ É̄ → x² 10⁻³ κ₀ and a very long title that goes on and on until it has no more room at all, really none".into(),
        subtitle: "<b>&\"quotes\"</b> Привет Ελλάδα".into(), x_label: "Rate (rad/s)".into(),
        panels: vec![
            Panel { y_label: "Stiffness (N/m)".into(), series: (0..9).map(|k| s(&format!("series number {k} of nine"), [Style::Line, Style::Dashed, Style::Dots][k%3], (0..40).map(|i| (i as f64*1e4, Some(1e6*(1.0+k as f64*0.3)*(1.0+(i as f64*0.2+k as f64).sin())))).collect())).collect() },
            Panel { y_label: "Tiny (m)".into(), series: vec![s("noise", Style::Line, (0..200000).map(|i| (i as f64*2.0, Some(1e-5*((i as f64*1.1).sin()+ (i as f64*1e-5).cos())))).collect()), s("measured", Style::Dots, (0..60).map(|i| (i as f64*6000.0, Some(3e-5*(i as f64*0.1).cos()))).collect())] },
            Panel { y_label: "Flat (kg)".into(), series: vec![s("c", Style::Line, vec![(0.0,Some(207.342)),(1e5,Some(207.342)),(2e5,None),(3e5,Some(207.342))])] },
            Panel { y_label: "Empty (kg)".into(), series: vec![] },
            Panel { y_label: "Close (kg)".into(), series: vec![s("c", Style::Line, vec![(0.0,Some(207.342)),(4e5,Some(207.342003))])] },
        ],
        marks: (0..12).map(|i| Mark { x: i as f64*2.2e4, label: format!("mark no. {i}") }).collect() };
    std::fs::write("/tmp/render-probe/z.png", f.to_png(1.0).unwrap()).unwrap();
    std::fs::write("/tmp/render-probe/z.svg", f.to_svg()).unwrap();
    let f = Figure { panels: vec![Panel { y_label: "m̄ (kg)".into(), series: vec![s("", Style::Line, vec![(3.0, Some(12.5))])] }], ..Default::default() };
    std::fs::write("/tmp/render-probe/o.png", f.to_png(1.0).unwrap()).unwrap();
}
