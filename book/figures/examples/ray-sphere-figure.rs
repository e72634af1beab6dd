//! The figure of the page ray-sphere.

figures::exports!(ray_sphere::figure::RayAndSphere);
