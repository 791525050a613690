//! Energy at impacts.

use exact_ccd_sim::{BodyKind, Integrator, Settings, Simulation, System, shapes};

/// The mechanical energy of a stiff cube that falls on a floor never increases by more than a hundredth of
/// its energy at the start, which is relative to the floor.
#[test]
fn bdf2_does_not_gain_energy_at_impacts() {
    for (young, time_step) in [(1e8, 0.01), (1e6, 0.01), (1e8, 0.005)] {
        let mut cube = shapes::solid_box([1, 1, 1], [0.2; 3]).placed(|[x, y, z]| [x, y + 0.5, z]);
        if let BodyKind::Solid { material, .. } = &mut cube.kind {
            material.young = young;
        }
        let floor = shapes::floor([1, 1], [3.0, 3.0]).placed(|[x, y, z]| [x - 1.4, y, z - 1.4]);
        let system = System::new(&[cube, floor], &[]).unwrap();
        let settings = Settings {
            integrator: Integrator::Bdf2,
            time_step,
            ..Settings::default()
        };
        let mut simulation = Simulation::new(system, settings).unwrap();
        let (mut least, mut start, mut touched) = (f64::INFINITY, 0.0, false);
        for step in 0..(1.0 / time_step) as u32 {
            let statistics = simulation.step().unwrap();
            let energy = statistics.energies.mechanical();
            if step == 0 {
                start = energy;
            }
            touched |= statistics.contacts > 0;
            least = least.min(energy);
            assert!(
                energy - least < 0.01 * start,
                "E = {young}, h = {time_step}, step {step}: {energy} after {least} of {start}"
            );
        }
        assert!(touched);
    }
}
