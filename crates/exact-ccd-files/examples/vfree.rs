use std::path::Path;
use std::time::Instant;
use exact_ccd_mesh::*;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let motion = exact_ccd_files::read_motion(Path::new(&a[1]), Path::new(&a[2])).unwrap();
    let mut d = Detector::new(motion.mesh.clone());
    let o = FreeStepOptions::default();
    let mut ratios = vec![];
    let n: usize = a.get(3).map_or(5, |x| x.parse().unwrap());
    let mut last = None;
    for _ in 0..n {
        let t = Instant::now();
        let c = d.free_step(&motion.x0, &motion.x1, &o).unwrap();
        let tc = t.elapsed().as_secs_f64();
        let t = Instant::now();
        let s = d.free_steps(&motion.x0, &motion.x1, &[], &o).unwrap();
        let ts = t.elapsed().as_secs_f64();
        ratios.push((ts / tc, tc, ts));
        last = Some((c, s));
    }
    let (c, s) = last.unwrap();
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    let n = s.sizes.len() as f64;
    println!("common {:.3e}, mean {:.4}, at one {:.4}, least {:.3e}, rounds {}, blocked {}, ratio {:?}", c.size,
        s.sizes.iter().sum::<f64>() / n, s.sizes.iter().filter(|&&x| x == 1.0).count() as f64 / n,
        s.sizes.iter().copied().fold(1.0, f64::min), s.rounds, s.blocked.len(), ratios[ratios.len() / 2]);
}
