//! Whether this machine has the instructions that the program was built with, and whether it has more.
//!
//! Packages hold two builds of the same program: `bin/zpg` for every processor, and `lib/zpg/zpg-x86-64-v3` for those
//! with AVX2 and FMA. The first hands over to the second where it can.

#[cfg(all(target_arch = "x86_64", target_feature = "fma"))]
pub use with_fma::suffices;

#[cfg(not(all(target_arch = "x86_64", target_feature = "fma")))]
pub use without_fma::suffices;

/// The build with AVX2 and FMA.
#[cfg(all(target_arch = "x86_64", target_feature = "fma"))]
mod with_fma {
    /// The message where the processor lacks AVX2 or FMA, in both languages: the user's language is not known yet.
    const TOO_OLD: &str = "error: this zpg was built for processors with AVX2 and FMA, and this one has not got them; \
        build it with RUSTFLAGS=\"-C target-cpu=x86-64\" cargo install --path .\n\
        chyba: toto zpg je sestaveno pro procesory s AVX2 a FMA a tento je nemá; \
        sestavte ho příkazem RUSTFLAGS=\"-C target-cpu=x86-64\" cargo install --path .";

    /// Checks whether the processor has the instructions of this build. The error is a message for the user.
    ///
    /// The standard library's own test is no use: it takes for granted what the program was built for. Only whole
    /// numbers are computed here, since the function has to run on the machines that it refuses.
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
}

/// The build that runs on every processor of its architecture.
#[cfg(not(all(target_arch = "x86_64", target_feature = "fma")))]
mod without_fma {
    /// Always succeeds: this build runs on every processor. Where a faster build lies beside it and can run, that one
    /// runs instead.
    #[expect(clippy::unnecessary_wraps, reason = "the other build can fail to run")]
    pub fn suffices() -> Result<(), &'static str> {
        #[cfg(all(target_arch = "x86_64", unix))]
        hand_over();
        Ok(())
    }

    /// Becomes the build with AVX2 and FMA if the processor has both and the package has that build. Both draw the same
    /// pictures, so whatever goes wrong, this build goes on.
    #[cfg(all(target_arch = "x86_64", unix))]
    fn hand_over() {
        use std::os::unix::process::CommandExt;
        if !has_fma() {
            return;
        }
        let Some(faster) = faster() else { return };
        let mut args = std::env::args_os();
        let mut command = std::process::Command::new(faster);
        if let Some(name) = args.next() {
            command.arg0(name);
        }
        // `exec` returns only if it fails.
        let _ = command.args(args).exec();
    }

    /// Whether this processor has all instructions of x86-64-v3 that a compiler makes use of.
    #[cfg(all(target_arch = "x86_64", unix))]
    fn has_fma() -> bool {
        is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2")
            && is_x86_feature_detected!("f16c")
            && is_x86_feature_detected!("lzcnt")
            && is_x86_feature_detected!("movbe")
    }

    /// The path of the build with AVX2 and FMA, if there is one. `None` if this program itself, or a link to it, has
    /// the name of that build: it would hand over to itself for ever.
    #[cfg(all(target_arch = "x86_64", unix))]
    fn faster() -> Option<std::path::PathBuf> {
        const NAME: &str = "zpg-x86-64-v3";
        let own = std::env::current_exe().ok()?.canonicalize().ok()?;
        let prefix = own.parent()?.parent()?;
        let faster = prefix.join("lib/zpg").join(NAME).canonicalize().ok()?;
        let named = |path: &std::path::Path| path.file_name().is_some_and(|n| n == NAME);
        (named(&faster) && !named(&own)).then_some(faster)
    }
}
