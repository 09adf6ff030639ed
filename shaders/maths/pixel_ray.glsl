// The ray of a pixel: from the eye through the point (x, y) of the picture, in columns, rows and metres of height
// per metre of ray. The including side gives, per metre of ray before normalisation,
//   ray_forward, ray_right, ray_up   real3, world metres (east, north, up); right and up reach the picture's edges
//   cells_per_m                      real2, columns and rows per metre
// picture: -1 to 1 from left to right and from bottom to top.
real3 pixel_ray(real2 picture) {
    real x = ray_forward.x + picture.x * ray_right.x + picture.y * ray_up.x;
    real y = ray_forward.y + picture.x * ray_right.y + picture.y * ray_up.y;
    real z = ray_forward.z + picture.x * ray_right.z + picture.y * ray_up.z;
    real inverse_length = real(1) / sqrt(x * x + y * y + z * z);
    // Rows run south, y runs north.
    return real3(x * inverse_length * cells_per_m.x, -y * inverse_length * cells_per_m.y, z * inverse_length);
}
