//! Whether this machine has the instructions that the program was built with.

/// What is said where it has not, in both languages: nothing is known of the user yet.
#[cfg(all(target_arch = "x86_64", target_feature = "fma"))]
const TOO_OLD: &str = "error: this zpg was built for processors with AVX2 and FMA, and this one has not got them; \
    build it with RUSTFLAGS=\"-C target-cpu=x86-64\" cargo install --path .\n\
    chyba: toto zpg je sestaveno pro procesory s AVX2 a FMA a tento je nemá; \
    sestavte ho příkazem RUSTFLAGS=\"-C target-cpu=x86-64\" cargo install --path .";

/// Whether the program can run here; says what is missing.
///
/// The standard library's own test is no use: it answers with what the program was built for. Nothing but
/// whole numbers is computed here: this has to run on the machines that it refuses.
#[cfg(all(target_arch = "x86_64", target_feature = "fma"))]
#[inline(never)]
pub fn suffices() -> Result<(), &'static str> {
    use std::arch::x86_64::{__cpuid, __cpuid_count};
    // Intel 64 and IA-32 Architectures Software Developer's Manual, volume 2, CPUID.
    const FMA: u32 = 1 << 12;
    const MOVBE: u32 = 1 << 22;
    const OSXSAVE: u32 = 1 << 27;
    const AVX: u32 = 1 << 28;
    const F16C: u32 = 1 << 29;
    const BASIC: u32 = FMA | MOVBE | OSXSAVE | AVX | F16C;
    const BMI1: u32 = 1 << 3;
    const AVX2: u32 = 1 << 5;
    const BMI2: u32 = 1 << 8;
    const EXTENDED: u32 = BMI1 | AVX2 | BMI2;
    let basic = __cpuid(1).ecx;
    let leaves = __cpuid(0).eax;
    let extended = if leaves < 7 {
        0
    } else {
        __cpuid_count(7, 0).ebx
    };
    if basic & BASIC == BASIC && extended & EXTENDED == EXTENDED {
        Ok(())
    } else {
        Err(TOO_OLD)
    }
}

/// Every machine of this kind will do.
#[cfg(not(all(target_arch = "x86_64", target_feature = "fma")))]
pub fn suffices() -> Result<(), &'static str> {
    Ok(())
}
