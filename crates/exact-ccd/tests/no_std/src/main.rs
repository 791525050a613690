//! A program for x86-64 Linux that links the kernel without the standard library, and uses it in
//! the floating-point environments of a C program: rounding in each direction, with gradual underflow or,
//! as after `-ffast-math`, with subnormal numbers flushed to zero.
//!
//! The exit status is 0 if all answers are exact, otherwise the number of the first wrong one, in
//! environment i from 1 + 10 i; 101 is a panic.

#![no_std]
#![no_main]

mod symbols;

use core::alloc::{GlobalAlloc, Layout};
use core::arch::{asm, global_asm};
use core::cmp::Ordering;
use core::hint::black_box;
use core::panic::PanicInfo;
use core::ptr::null_mut;
use core::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use exact_ccd::batch::{self, Trajectories};
use exact_ccd::predicates::{EdgeFace, orient3d};
use exact_ccd::{
    CONTACT, Collision, ContactTime, EdgeEdge, Kind, Point, Query, Separation, Stage, VertexEdge, VertexFace,
    environment,
};

/// The smallest subnormal number.
const TINY: f64 = f64::from_bits(1);

/// Allocates memory from a fixed block, and frees none.
struct Bump {
    used: AtomicUsize,
}

const SIZE: usize = 16 << 20;
static mut HEAP: [u8; SIZE] = [0; SIZE];

// SAFETY: each block lies in HEAP, is aligned, and is handed out only once.
unsafe impl GlobalAlloc for Bump {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let heap = &raw mut HEAP as usize;
        let used = self.used.load(Relaxed);
        let start = (heap + used).next_multiple_of(layout.align());
        let end = start + layout.size();
        if end > heap + SIZE {
            return null_mut();
        }
        self.used.store(end - heap, Relaxed);
        start as *mut u8
    }

    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static ALLOCATOR: Bump = Bump {
    used: AtomicUsize::new(0),
};

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    exit(101)
}

// The stack is aligned to 16 bytes at the entry of the program; a call expects the return address
// below that.
global_asm!(".globl _start", "_start:", "xor ebp, ebp", "call {start}", "ud2", start = sym start);

extern "C" fn start() -> ! {
    exit(wrong_answer().unwrap_or(0))
}

fn exit(status: i32) -> ! {
    // SAFETY: the system call `exit_group` ends the program.
    unsafe { asm!("syscall", in("rax") 231, in("rdi") status, options(noreturn)) }
}

/// The bits of the control register that flush subnormal numbers (FTZ, DAZ), and those of the rounding.
const FLUSH: u32 = 0x8040;
const DOWN: u32 = 0x2000;
const UP: u32 = 0x4000;
const TO_ZERO: u32 = 0x6000;

/// All environments: the default one first.
const ENVIRONMENTS: [u32; 8] = [
    0,
    DOWN,
    UP,
    TO_ZERO,
    FLUSH,
    FLUSH | DOWN,
    FLUSH | UP,
    FLUSH | TO_ZERO,
];

/// Sets the environment of this thread.
fn set(environment: u32) {
    let mut control = 0_u32;
    // SAFETY: only the rounding and the treatment of subnormal numbers change, and the kernel detects it.
    unsafe {
        asm!("stmxcsr [{}]", in(reg) &raw mut control, options(nostack));
        control = control & !(FLUSH | TO_ZERO) | environment;
        asm!("ldmxcsr [{}]", in(reg) &raw const control, options(nostack));
    }
}

/// The number of the first wrong answer.
fn wrong_answer() -> Option<i32> {
    // Contact at 1/3, a time that the filters round.
    let at = |z: f64| [[1.0, 2.0, z], FACE[0], FACE[1], FACE[2]];
    let falling = Query::<VertexFace>::new(at(1.0), at(-2.0)).ok()?;
    let collision = falling.collision(CONTACT)?;
    let times = collision.intervals();
    let coplanar = Coplanar::new();
    // Contact between 0 and the least f64 above it, which may be read as 0.
    let least = f64::from_bits(1);
    let soon = Query::<VertexFace>::new(at(least), at(-1.0)).ok()?;
    for (first, environment) in (1..).step_by(10).zip(ENVIRONMENTS) {
        let is_default = environment == 0;
        set(environment);
        let ordinary = answers(1.0);
        let subnormal = answers(TINY);
        let stage = vertex_face(1.0).decide(CONTACT).1;
        // Decided in the default environment, read in this one.
        let later = collision.intervals();
        let is_before = soon.collision(CONTACT)?.is_before(black_box(least));
        // Here, not after the next change of the environment.
        let detected = black_box(!environment::is_default());
        let are_contacts_exact = coplanar.are_decided();
        set(0);
        let is_right = [
            ordinary == Some(EXPECTED),
            subnormal == Some(EXPECTED),
            // The environment is detected, and filters are in use only in the default one.
            detected != is_default,
            (stage == Stage::Exact) != is_default,
            later == times,
            is_before,
            are_contacts_exact,
        ];
        if let Some(index) = is_right.iter().position(|&is_right| !is_right) {
            return Some(first + index as i32);
        }
    }
    None
}

/// Queries whose points are all in the plane x = −y, so that rounding in different directions tears their
/// coordinates apart, and their answers in integers.
struct Coplanar {
    queries: [[[Point; 4]; 2]; Self::COUNT],
    collide: [[bool; 2]; Self::COUNT],
}

impl Coplanar {
    const COUNT: usize = 300;

    fn new() -> Self {
        let mut bits = 0;
        let mut point = || {
            let [x, z] = [0; 2].map(|_| random(&mut bits));
            [x, -x, z]
        };
        let queries = [(); Self::COUNT].map(|()| [[(); 4]; 2].map(|points| points.map(|()| point())));
        let collide = queries.map(|[t0, t1]| {
            let start = ALLOCATOR.used.load(Relaxed);
            let vertex_face =
                Query::<VertexFace>::new(t0, t1).is_ok_and(|query| query.exactly().collides(CONTACT));
            let edge_edge =
                Query::<EdgeEdge>::new(t0, t1).is_ok_and(|query| query.exactly().collides(CONTACT));
            ALLOCATOR.used.store(start, Relaxed);
            [vertex_face, edge_edge]
        });
        Self { queries, collide }
    }

    /// Returns true if single queries and batches, for contact and within a distance, are decided as in
    /// integers.
    fn are_decided(&self) -> bool {
        let count = |of: usize| self.collide.iter().filter(|collide| collide[of]).count();
        count(0) > 30 && count(1) > 30 && self.is_decided::<VertexFace>(0) && self.is_decided::<EdgeEdge>(1)
    }

    fn is_decided<K: Kind<Points = [Point; 4]>>(&self, of: usize) -> bool {
        let Ok(tiny) = Separation::new(f64::MIN_POSITIVE) else {
            return false;
        };
        // Of 300 queries, those of index 0, 7, 14, … within a distance: they take long.
        self.queries
            .iter()
            .zip(&self.collide)
            .enumerate()
            .all(|(index, (&[t0, t1], collide))| {
                let start = ALLOCATOR.used.load(Relaxed);
                let is_right = Query::<K>::new(t0, t1).is_ok_and(|query| {
                    let within = index % 7 != 0 || !collide[of] || query.collides(tiny);
                    query.collides(CONTACT) == collide[of] && within
                });
                let mut found = false;
                let batch = [[t0, t1]];
                let batch = batch::Queries::<K>::new(&batch);
                let mut of_batch = |_: usize, _: Collision<'_, K>| found = true;
                let is_valid = batch.collisions(CONTACT, &mut of_batch).is_ok();
                ALLOCATOR.used.store(start, Relaxed);
                is_right && is_valid && found == collide[of]
            })
    }
}

/// The next number of a sequence of pseudo-random ones (SplitMix64): of either sign, with 53 bits and a
/// magnitude from 1/16 to 1, so that most differences are not f64.
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    let z = z ^ (z >> 31);
    let (sign, exponent) = (z & 1 << 63, 1022 - (z >> 52 & 3));
    f64::from_bits(sign | exponent << 52 | z & ((1 << 52) - 1))
}

/// The answers to some queries, which do not depend on the unit of length.
#[derive(PartialEq)]
struct Answers {
    falling: Option<f64>,
    parallel: Option<usize>,
    batch: [bool; 2],
    array: [bool; 2],
    orientation: Ordering,
    intersects: bool,
    first_within: [[u64; 2]; 2],
    is_above_zero: bool,
    refused: [bool; 2],
}

const EXPECTED: Answers = Answers {
    falling: Some(0.5),
    parallel: None,
    batch: [true, false],
    array: [true, false],
    orientation: Ordering::Greater,
    intersects: true,
    first_within: [[1, 2], [1, 2]],
    is_above_zero: true,
    refused: [true, true],
};

const FACE: [Point; 3] = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]];

/// Points in a unit. It keeps the bits of small integers, in any environment.
fn scaled<const N: usize>(points: [Point; N], unit: f64) -> [Point; N] {
    points.map(|point| {
        point.map(|x| {
            if unit == 1.0 {
                return x;
            }
            let magnitude = f64::from_bits(x.abs() as u64 * unit.to_bits());
            if x.is_sign_negative() {
                -magnitude
            } else {
                magnitude
            }
        })
    })
}

fn vertex_face(unit: f64) -> Query<VertexFace> {
    let at = |z: f64| scaled([[1.0, 2.0, z], FACE[0], FACE[1], FACE[2]], unit);
    match Query::new(at(1.0), at(-1.0)) {
        Ok(query) => query,
        Err(_) => exit(102),
    }
}

fn answers(unit: f64) -> Option<Answers> {
    let [b0, b1] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
    let edges = scaled([[1.0, 0.0, 0.0], [6.0, 0.0, 0.0], b0, b1], unit);
    let resting = Query::<EdgeEdge>::new(edges, edges).ok()?;

    let at = |z: f64| scaled([[1.0, 2.0, z], [7.0, 7.0, z], FACE[0], FACE[1], FACE[2]], unit);
    let trajectories = Trajectories::new(&at(1.0), &at(-1.0)).ok()?;
    let mut of_batch = [false; 2];
    trajectories
        .collisions::<VertexFace>(&[[0, 2, 3, 4], [1, 2, 3, 4]], CONTACT, |index, _| {
            of_batch[index] = true
        })
        .ok()?;
    let points = |index: usize, z: f64| {
        let [a, b, v1, v2, v3] = at(z);
        [[a, b][index], v1, v2, v3]
    };
    let queries = [0, 1].map(|index| [points(index, 1.0), points(index, -1.0)]);
    let mut of_array = [false; 2];
    let queries = batch::Queries::<VertexFace>::new(&queries);
    queries
        .collisions(CONTACT, |index, _| of_array[index] = true)
        .ok()?;

    let [a, b] = scaled([[1.0, 2.0, 1.0], [1.0, 2.0, -1.0]], unit);
    let [v1, v2, v3] = scaled(FACE, unit);
    Some(Answers {
        falling: vertex_face(unit).time_of_impact(CONTACT),
        parallel: resting.intervals(CONTACT).count(),
        batch: of_batch,
        array: of_array,
        orientation: orient3d([v1, v2, v3, b]).ok()?,
        intersects: EdgeFace::new([a, b], [v1, v2, v3]).ok()?.intersects(),
        first_within: first_within()?,
        is_above_zero: !Separation::new(black_box(TINY)).ok()?.is_zero(),
        refused: [
            Separation::new(black_box(-TINY)).is_err(),
            resting.distance_at(black_box(-TINY)).is_err(),
        ],
    })
}

/// The bits of the two f64 around a subnormal time at which a vertex and an edge are first within a distance,
/// of two functions. The edge gets there at 1.6 times the smallest subnormal number, its ends much later.
fn first_within() -> Option<[[u64; 2]; 2]> {
    const HUGE: f64 = 1.25 * f64::from_bits(2046 << 52);
    let at = |y: f64| {
        [
            [0.0, 1.0 + 4.0 * f64::EPSILON, 0.0],
            [-0.5, y, 0.0],
            [0.5, y, 0.0],
        ]
    };
    let query = Query::<VertexEdge>::new(at(0.0), at(HUGE)).ok()?;
    let d = Separation::new(1.0).ok()?;
    let first = query.collision(d)?.time();
    let impact = query.impact(d)?;
    let bits = |time: ContactTime| {
        (!time.is_start() && !time.is_exact()).then(|| [time.lower(), time.upper()].map(f64::to_bits))
    };
    Some([bits(first)?, bits(impact.time)?])
}
