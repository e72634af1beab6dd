//! The same loop compiled twice; this is the only place of the project with `unsafe`.
//!
//! Every x86-64 processor has SSE2, whose registers hold 4 numbers of `f32` or 2 of `f64`. Most have AVX2
//! too: 8 or 4. A program is compiled for the least of them, so the better version is compiled beside it,
//! and the processor is asked when the program runs.
//!
//! Both give the same bits, as each lane is rounded as a number by itself would be. Fused multiply-add,
//! which most processors with AVX2 have as well, is not asked for: it rounds once where the formula
//! rounds twice.
//!
//! Neither may be inlined. Nothing that a function is given overlaps with what it is given as `&mut`, so
//! that it may read many rays before it writes an answer. The compiler knows that of a function's own
//! arguments, and forgets it in the caller: there it would go ray by ray.

use math::{Real, Span};

use super::packet::{Packet, PacketHits, first_hits};

/// Which of the compiled versions to run. The answers are the same to the last bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// What every processor of its kind has.
    Baseline,
    /// The best that this one has: AVX2 on an x86-64 processor with it, else the baseline.
    Best,
}

/// [`first_hits`] for every packet.
pub(super) fn run<R: Real>(
    instructions: Instructions,
    packets: &[Packet<R>],
    span: Span<R>,
    hits: &mut [PacketHits<R>],
) {
    match instructions {
        Instructions::Baseline => baseline(packets, span, hits),
        Instructions::Best => best(packets, span, hits),
    }
}

#[inline(never)]
fn baseline<R: Real>(packets: &[Packet<R>], span: Span<R>, hits: &mut [PacketHits<R>]) {
    every_packet(packets, span, hits);
}

#[cfg(target_arch = "x86_64")]
#[expect(unsafe_code, reason = "to call what is compiled for AVX2 from what is not")]
fn best<R: Real>(packets: &[Packet<R>], span: Span<R>, hits: &mut [PacketHits<R>]) {
    #[inline(never)]
    #[target_feature(enable = "avx2")]
    fn avx2<R: Real>(packets: &[Packet<R>], span: Span<R>, hits: &mut [PacketHits<R>]) {
        every_packet(packets, span, hits);
    }

    if is_x86_feature_detected!("avx2") {
        // SAFETY: `avx2` is safe code; it asks only that the processor has AVX2, which it just said.
        unsafe { avx2(packets, span, hits) }
    } else {
        baseline(packets, span, hits);
    }
}

#[cfg(not(target_arch = "x86_64"))]
fn best<R: Real>(packets: &[Packet<R>], span: Span<R>, hits: &mut [PacketHits<R>]) {
    baseline(packets, span, hits);
}

/// Inlined into either version with all that it calls, so that each has it in its own instructions.
#[inline(always)]
fn every_packet<R: Real>(packets: &[Packet<R>], span: Span<R>, hits: &mut [PacketHits<R>]) {
    for (packet, hits) in packets.iter().zip(hits) {
        first_hits(packet, span, hits);
    }
}
