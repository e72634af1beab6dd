//! The figure of the page whitted.

figures::exports!(whitted::figure::RayAndSurface);
