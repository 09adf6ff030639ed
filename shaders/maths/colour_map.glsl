// A colour scale of even steps for the eye, dark blue to yellow, readable for colour-blind people: five stops of the
// viridis scale (van der Walt & Smith 2015), linear between. share: 0 to 1.
real3 colour_map(real share) {
    real x = min(max(share, real(0)), real(1)) * real(4);
    real3 a = real3(real(0.267), real(0.005), real(0.329));
    real3 b = real3(real(0.229), real(0.322), real(0.546));
    if (x >= real(1)) { a = b; b = real3(real(0.128), real(0.567), real(0.551)); }
    if (x >= real(2)) { a = b; b = real3(real(0.369), real(0.789), real(0.383)); }
    if (x >= real(3)) { a = b; b = real3(real(0.993), real(0.906), real(0.144)); }
    real w = x - floor(min(x, real(3.999)));
    return a + (b - a) * w;
}

// A colour scale that ends where it begins, for directions: from north, blue, to south, yellow, and from east, dark, to
// west, light; two axes that colour-blind people tell apart too.
real3 direction_map(real share) {
    real x = (share - floor(share)) * real(4);
    real3 north = real3(real(0.27), real(0.42), real(0.78));
    real3 east = real3(real(0.13), real(0.27), real(0.23));
    real3 south = real3(real(0.93), real(0.75), real(0.20));
    real3 west = real3(real(0.97), real(0.91), real(0.94));
    real3 a = x < real(1) ? north : x < real(2) ? east : x < real(3) ? south : west;
    real3 b = x < real(1) ? east : x < real(2) ? south : x < real(3) ? west : north;
    return a + (b - a) * (x - floor(x));
}

// A colour scale for what lies below and above: blue, near white in the middle (share one half), red; readable for
// colour-blind people.
real3 difference_map(real share) {
    real x = min(max(share, real(0)), real(1)) * real(2) - real(1);
    real3 middle = real3(real(0.93), real(0.92), real(0.90));
    real3 end = x < real(0) ? real3(real(0.13), real(0.33), real(0.62)) : real3(real(0.70), real(0.16), real(0.14));
    real w = min(sqrt(abs(x)), real(1));
    return middle + (end - middle) * w;
}

// The colour of a kind of pixel (render/methods/method.h): mesh, rays, rays that ended early by level.
real3 kind_map(real kind) {
    real3 early = real3(real(0.55), real(0.85), real(0.45));
    real w = min(max((kind - real(3)) / real(5), real(0)), real(1));
    early = early + (real3(real(0.10), real(0.45), real(0.25)) - early) * w;
    return kind < real(1.5) ? real3(real(0.30), real(0.55), real(0.85))
                            : kind < real(2.5) ? real3(real(0.95), real(0.75), real(0.35)) : early;
}
