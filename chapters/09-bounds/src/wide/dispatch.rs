//! The same work compiled twice; with its like in chapter 04 the only place with `unsafe`.
//!
//! What every x86-64 processor has is compiled in, and beside it a version for those with AVX2 (and the instructions
//! for counting bits that came with it). The processor is asked when a tree is built; a ray takes so little time that
//! asking each time would show. Fused multiply-add is not asked for, as it rounds once where the formulas round twice.

/// Which of the compiled versions to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// What every processor of its kind has.
    Baseline,
    /// The best that this one has.
    Best,
}

/// A version that this processor can run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Version {
    /// True only if [`Version::of`] has found that the processor has it all.
    has_avx2: bool,
}

impl Version {
    pub(crate) fn of(instructions: Instructions) -> Version {
        #[cfg(target_arch = "x86_64")]
        let has_avx2 = is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2")
            && is_x86_feature_detected!("lzcnt");
        #[cfg(not(target_arch = "x86_64"))]
        let has_avx2 = false;
        Version { has_avx2: has_avx2 && instructions == Instructions::Best }
    }

    #[inline(always)]
    pub(crate) fn run<W: Work>(self, work: W) -> W::Answer {
        #[cfg(target_arch = "x86_64")]
        #[expect(unsafe_code, reason = "to call what is compiled for AVX2 from what is not")]
        if self.has_avx2 {
            // SAFETY: `avx2` is safe code; it asks only that the processor has what `Version::of` found.
            return unsafe { avx2(work) };
        }
        baseline(work)
    }
}

/// Something to be compiled for more than one kind of processor: `run` and all that it calls is inlined into either
/// version.
pub(crate) trait Work {
    type Answer;
    fn run(self) -> Self::Answer;
}

#[inline(never)]
fn baseline<W: Work>(work: W) -> W::Answer {
    work.run()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2,bmi1,bmi2,lzcnt")]
fn avx2<W: Work>(work: W) -> W::Answer {
    work.run()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of the best version it depends on the processor.
    #[test]
    fn the_baseline_is_what_every_processor_has() {
        assert!(!Version::of(Instructions::Baseline).has_avx2);
        #[cfg(target_arch = "x86_64")]
        assert!(Version::of(Instructions::Best).has_avx2 || !is_x86_feature_detected!("lzcnt"));
    }
}
