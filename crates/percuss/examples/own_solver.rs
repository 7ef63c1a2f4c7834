//! Computes m̄ from the matrices M, A and j of a four-bar with a separate solver; the null space of A is found by QR.
//!
//! m̄ = min { vᵀMv : Av = 0, jv = 1 } = 1/(j Z (ZᵀMZ)⁻¹ Zᵀ jᵀ); the columns of Z are a basis of ker A, and ZᵀMZ
//! must be regular. `cargo run -p percuss --example own_solver`

use percuss::nalgebra::{DMatrix, DVector};
use percuss::{Conditions, Contact, EffectiveMass, LoadOptions, Source, System, load};
use std::error::Error;

/// Orthonormal basis of ker A, n×(n − rank). A may have redundant rows and fewer than n rows.
fn null_space(a: &DMatrix<f64>) -> DMatrix<f64> {
    let n = a.ncols();
    // Padding with zero rows to at least n rows makes Q square.
    let padded = a.clone().resize_vertically(a.nrows().max(n), 0.0);
    let qr = padded.transpose().col_piv_qr();
    let (q, r) = (qr.q(), qr.r());
    let rank = (0..n).take_while(|&i| r[(i, i)].abs() > 1e-10 * r[(0, 0)].abs()).count();
    q.columns(rank, n - rank).into_owned()
}

/// m̄, kg; `None` if no motion closes the gap or M is singular on ker A.
fn effective_mass(m: &DMatrix<f64>, a: &DMatrix<f64>, j: &DVector<f64>) -> Option<f64> {
    let z = null_space(a);
    let along = z.tr_mul(j);
    let inverse = along.dot(&(z.transpose() * m * &z).cholesky()?.solve(&along));
    (inverse > 0.0).then(|| 1.0 / inverse)
}

/// Compares both results at some crank angles.
pub fn main() -> Result<(), Box<dyn Error>> {
    let text = include_str!("../../../models/four_bar.urdf");
    let mechanism = load(&Source::from_text("four_bar.urdf", text), &LoadOptions::default())?.mechanism;
    let contact = Contact::new(mechanism.find_link("coupler")?, [0.35, 0.1, 0.0], [0.0, 1.0, 0.0]);
    let system = System::new(mechanism, &Conditions::new())?;
    for degrees in [0.0_f64, 40.0, 110.0, 250.0] {
        let mut configuration = system.configuration();
        configuration.set("crank_hinge", &[degrees.to_radians()])?;
        let pose = system.pose(&configuration)?;
        let j = DVector::from_vec(pose.contact_row(&pose.locate(&contact)?));
        let own =
            effective_mass(&pose.mass_matrix(), &pose.constraint_matrix(), &j).ok_or("no finite mass")?;
        let response = pose.respond(&contact)?;
        let EffectiveMass::Finite(expected) = response.effective_mass else {
            return Err("not finite".into());
        };
        println!("crank at {degrees:3}°: own {own:.12} kg, percuss {expected:.12} kg");
        if (own / expected - 1.0).abs() > 1e-10 {
            return Err(format!("{own} kg and {expected} kg differ").into());
        }
    }
    Ok(())
}
