// Values of the tables over a tick at shares of it. Needs maths/two_sum.glsl, and
//   real load_tick_series(int): the tables, one behind the other
#include "maths/tick_series.glsl"

// A table of points between them, linear.
real tick_series_at(int table, real share) {
    precise real place = share * real(tick_series_steps);
    int step = min(max(int(place), 0), tick_series_steps - 1);
    precise real part = place - real(step);
    int base = table * tick_series_points + step;
    precise real value = load_tick_series(base) + part * (load_tick_series(base + 1) - load_tick_series(base));
    return value;
}

// The integral of a table of means from one share of the tick to another, in parts of the tick. Spans that follow each other sum
// up to that of the whole: each begins where the one before ended, to the bit.
real tick_series_integral(int table, real from, real to) {
    precise real first_place = from * real(tick_series_steps);
    precise real last_place = to * real(tick_series_steps);
    int first = min(max(int(first_place), 0), tick_series_steps - 1);
    int last = min(max(int(last_place), first), tick_series_steps - 1);
    int base = table * tick_series_points;
    real2 sum = real2(real(0), real(0));
    real begin = first_place;
    for (int step = first; step <= last; ++step) {
        real end = step == last ? last_place : real(step + 1);
        precise real part = (end - begin) * load_tick_series(base + step);
        sum = add_increment(sum, part);
        begin = end;
    }
    precise real parts = sum.x / real(tick_series_steps);
    return parts;
}
