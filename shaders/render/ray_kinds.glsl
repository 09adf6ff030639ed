// What the rays of a block do. C++ compiles these lines too (render/methods/ray_casting.cpp).
const int kind_nothing = 0;
const int kind_flat = 1;          // they end in flat cells
const int kind_walk = 2;          // to the patch
const int kind_walk_or_flat = 3;
const int ray_kinds = 4;
