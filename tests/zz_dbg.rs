use percuss_oracle::linkage;
use percuss_tests::rig::Rig;
use rand::{Rng, SeedableRng, rngs::StdRng};
use std::time::Instant;
#[test]
fn dbg() {
    let rig = Rig::new(linkage::ladder(200));
        let mut off = rig.start.clone();
        let mut rng = StdRng::seed_from_u64(31);
        off.iter_mut().flatten().for_each(|q| *q += rng.random_range(-0.3..0.3));
    eprintln!("assembly");
    let _ = rig.system.pose(&rig.system.configuration());
    eprintln!("from guess");
    let t = Instant::now();
    let r = rig.system.pose(&rig.guessed(&rig.start_drivers(), &off));
    eprintln!("{:?} {:?}", t.elapsed(), r.map(|_| ()).map_err(|e| e.to_string().len()));
    let t = Instant::now();
    let p = rig.closed();
    eprintln!("closed {:?}", t.elapsed());
    let t = Instant::now();
    let p = rig.reach(&p, &rig.at(0.4));
    eprintln!("reach {:?}", t.elapsed());
    let t = Instant::now();
            let theta = rig.at(0.4)[0];
            let n = linkage::plane().vector(&nalgebra::Vector3::new(-theta.sin(), theta.cos(), 0.0));
            let contact = rig.contact("link_0", [0.2, 0.0, 0.0], n);
            let strike = rig.strike(&p, &contact);
    eprintln!("strike {:?} {:?} {:?}", t.elapsed(), strike.effective_mass, strike.effective_mass_error);
}
