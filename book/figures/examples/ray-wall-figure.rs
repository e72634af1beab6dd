//! The figure of the page ray-wall.

figures::exports!(ray_wall::figure::RayAndWall);
