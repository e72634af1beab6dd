//! The same work compiled twice; with its like in chapter 04 the only place with `unsafe`.
//!
//! What every x86-64 processor has is compiled in, and beside it a version for those with AVX2 (and the
//! instructions for counting bits that came with it). The processor is asked when the program runs: it
//! remembers its answer, and to look that up takes a nanosecond a ray. Fused multiply-add is not asked for,
//! as it rounds once where the formulas round twice.

/// Which of the compiled versions to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// What every processor of its kind has.
    Baseline,
    /// The best that this one has.
    Best,
}

/// Something to be compiled for more than one kind of processor: `run` and all that it calls is inlined into
/// either version.
pub(crate) trait Work {
    type Answer;
    fn run(self) -> Self::Answer;
}

#[inline(always)]
pub(crate) fn run<W: Work>(instructions: Instructions, work: W) -> W::Answer {
    match instructions {
        Instructions::Baseline => baseline(work),
        Instructions::Best => best(work),
    }
}

#[inline(never)]
fn baseline<W: Work>(work: W) -> W::Answer {
    work.run()
}

#[cfg(target_arch = "x86_64")]
#[expect(unsafe_code, reason = "to call what is compiled for AVX2 from what is not")]
#[inline(always)]
fn best<W: Work>(work: W) -> W::Answer {
    #[inline(never)]
    #[target_feature(enable = "avx2,bmi1,bmi2,lzcnt")]
    fn avx2<W: Work>(work: W) -> W::Answer {
        work.run()
    }

    if is_x86_feature_detected!("avx2")
        && is_x86_feature_detected!("bmi1")
        && is_x86_feature_detected!("bmi2")
        && is_x86_feature_detected!("lzcnt")
    {
        // SAFETY: `avx2` is safe code; it asks only that the processor has these, which it just said.
        unsafe { avx2(work) }
    } else {
        baseline(work)
    }
}

#[cfg(not(target_arch = "x86_64"))]
fn best<W: Work>(work: W) -> W::Answer {
    baseline(work)
}
