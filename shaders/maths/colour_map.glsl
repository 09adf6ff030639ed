// A colour scale of even steps for the eye, dark blue to yellow, readable for colour-blind people: five stops of the
// viridis scale (van der Walt & Smith 2015), linear between. share: 0 to 1.
real3 colour_map(real share) {
    real x = min(max(share, real(0)), real(1)) * real(4);
    real3 a = real3(real(0.267), real(0.005), real(0.329));
    real3 b = real3(real(0.229), real(0.322), real(0.546));
    if (x > real(1)) { a = b; b = real3(real(0.128), real(0.567), real(0.551)); }
    if (x > real(2)) { a = b; b = real3(real(0.369), real(0.789), real(0.383)); }
    if (x > real(3)) { a = b; b = real3(real(0.993), real(0.906), real(0.144)); }
    real w = x - floor(min(x, real(3.999)));
    return a + (b - a) * w;
}
