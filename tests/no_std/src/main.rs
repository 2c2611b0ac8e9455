//! A program of the library and nothing else: no std, no allocator, no C library.
//!
//! Linux on x86-64 only, since it speaks to the kernel itself. It exits with 0 when Si(pi), an arc, a
//! scratch and its sample have their known values. That it links at all is the proof: whatever the library called outside itself would be undefined.
#![no_std]
#![no_main]

use core::arch::asm;
use core::hint::black_box;
use core::panic::PanicInfo;

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    exit(2)
}

fn exit(code: i32) -> ! {
    // SAFETY: exit(2) takes one integer and does not return.
    unsafe { asm!("syscall", in("rax") 60, in("rdi") code, options(noreturn)) }
}

/// The entry point that a C library would otherwise provide.
// SAFETY: no other item of the program has this name.
#[unsafe(no_mangle)]
pub extern "C" fn _start() -> ! {
    // The kernel leaves the stack aligned for a process, not for a called function.
    // SAFETY: aligning the stack pointer downward before any local lives on it.
    unsafe { asm!("and rsp, -16", "call {main}", "ud2", main = sym run, options(noreturn)) }
}

extern "C" fn run() -> ! {
    let si = iridescence::special::sine_integral(black_box(core::f64::consts::PI));
    let line = iridescence::special::sinc_squared_integral(black_box([f64::NEG_INFINITY, f64::INFINITY]));
    let single = iridescence::shader::sine_integral(black_box(core::f32::consts::PI));
    let fit = iridescence::special::sine_integral_vwh18(black_box(1.0));
    let light = iridescence::diffraction::Coherence {
        radius: black_box(10.0),
        wavelength: 0.55,
    };
    let scratch = iridescence::diffraction::Segment {
        position: [0.0, 0.0],
        ends: [-black_box(f64::INFINITY), f64::INFINITY],
    };
    let eta = iridescence::diffraction::spatial_phase(light, scratch, [0.0, 0.0]).re;
    let sample = iridescence::sampling::scratch_lobe_sample(light, 2.0, [0.0, 0.0, 1.0], black_box([0.5, 0.5]));
    let up = sample.is_some_and(|s| s.direction[2] > 0.999 && s.pdf > 0.0);
    let text = black_box(iridescence::shader::WGSL.len());
    let right = si == 1.8519370519824663
        && line == core::f64::consts::PI
        && (single - 1.851937).abs() < 3e-7
        && (fit - 0.946).abs() < 0.051
        && (eta - 25.066282746310002).abs() < 1e-13
        && up
        && text > 1000;
    exit(i32::from(!right))
}
