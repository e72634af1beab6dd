//! The figure of the page ray-plane.

figures::exports!(ray_plane::figure::RayAndPlane);
