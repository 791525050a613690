//! A program for x86-64 Linux that links the kernel without the standard library, and uses it in
//! the floating-point environments of a C program: the default one, and that of `-ffast-math`,
//! which flushes subnormal numbers to zero.
//!
//! The exit status is 0 if all answers are exact, otherwise the number of the first wrong one; 101
//! is a panic.

#![no_std]
#![no_main]

mod symbols;

use core::alloc::{GlobalAlloc, Layout};
use core::arch::{asm, global_asm};
use core::cmp::Ordering;
use core::panic::PanicInfo;
use core::ptr::null_mut;
use core::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use exact_ccd::batch::{self, Trajectories};
use exact_ccd::predicates::{EdgeFace, orient3d};
use exact_ccd::separation::Separation;
use exact_ccd::{ContactTime, EdgeEdge, Point, Query, Stage, VertexEdge, VertexFace};

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

/// Sets or clears the bits FTZ and DAZ of the control register.
fn flush_subnormals(flush: bool) {
    let mut control = 0_u32;
    // SAFETY: only the treatment of subnormal numbers changes, and the kernel detects it.
    unsafe {
        asm!("stmxcsr [{}]", in(reg) &raw mut control, options(nostack));
        control = if flush {
            control | 0x8040
        } else {
            control & !0x8040
        };
        asm!("ldmxcsr [{}]", in(reg) &raw const control, options(nostack));
    }
}

/// The number of the first wrong answer.
fn wrong_answer() -> Option<i32> {
    let ordinary = answers(1.0);
    let subnormal = answers(TINY);
    flush_subnormals(true);
    let ordinary_flushed = answers(1.0);
    let subnormal_flushed = answers(TINY);
    let stage = vertex_face(1.0).collides_with_stage().1;
    flush_subnormals(false);
    [
        ordinary == Some(EXPECTED),
        subnormal == Some(EXPECTED),
        ordinary_flushed == Some(EXPECTED),
        subnormal_flushed == Some(EXPECTED),
        // The environment is detected, and filters are in use without it.
        stage == Stage::Exact,
        vertex_face(1.0).collides_with_stage().1 != Stage::Exact,
    ]
    .iter()
    .position(|&is_right| !is_right)
    .map(|index| index as i32 + 1)
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
    first_within: [u64; 2],
}

const EXPECTED: Answers = Answers {
    falling: Some(0.5),
    parallel: None,
    batch: [true, false],
    array: [true, false],
    orientation: Ordering::Greater,
    intersects: true,
    first_within: [1, 1],
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
        .collisions::<VertexFace>(&[[0, 2, 3, 4], [1, 2, 3, 4]], |index, _| of_batch[index] = true)
        .ok()?;
    let points = |index: usize, z: f64| {
        let [a, b, v1, v2, v3] = at(z);
        [[a, b][index], v1, v2, v3]
    };
    let queries = [0, 1].map(|index| [points(index, 1.0), points(index, -1.0)]);
    let mut of_array = [false; 2];
    let queries = batch::Queries::<VertexFace>::new(&queries);
    queries.collisions(|index, _| of_array[index] = true).ok()?;

    let [a, b] = scaled([[1.0, 2.0, 1.0], [1.0, 2.0, -1.0]], unit);
    let [v1, v2, v3] = scaled(FACE, unit);
    Some(Answers {
        falling: vertex_face(unit).time_of_impact(),
        parallel: resting.contact_times().count(),
        batch: of_batch,
        array: of_array,
        orientation: orient3d([v1, v2, v3, b]).ok()?,
        intersects: EdgeFace::new([a, b], [v1, v2, v3]).ok()?.intersects(),
        first_within: first_within()?,
    })
}

/// The bits of a subnormal time at which a vertex and an edge are first within a distance, of two
/// functions. The edge gets there at 1.6 times the smallest subnormal number, its ends much later.
fn first_within() -> Option<[u64; 2]> {
    const HUGE: f64 = 1.25 * f64::from_bits(2046 << 52);
    let at = |y: f64| [[0.0, 1.0 + 4.0 * f64::EPSILON, 0.0], [-0.5, y, 0.0], [0.5, y, 0.0]];
    let query = Query::<VertexEdge>::new(at(0.0), at(HUGE)).ok()?;
    let d = Separation::new(1.0).ok()?;
    let first = query.first_within(d)?;
    let impact = query.impact_within(d)?;
    let bits = |time: ContactTime| (!time.is_start() && !time.is_exact()).then(|| time.lower().to_bits());
    Some([bits(first)?, bits(impact.time)?])
}
