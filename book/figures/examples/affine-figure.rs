//! The figure of the page affine.

figures::exports!(affine::figure::Squashed);
