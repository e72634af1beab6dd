//! The figure of the page triangle.

figures::exports!(triangle::figure::RayAndTriangle);
