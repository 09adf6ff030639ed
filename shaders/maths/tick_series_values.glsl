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

// The mean of a table of means from one share of the tick to another. Spans that follow each other begin where the one before
// ended, to the bit, so that together they bring the table's integral. What is even stays even.
real tick_series_mean(int table, real from, real to) {
    precise real first_place = from * real(tick_series_steps);
    precise real last_place = to * real(tick_series_steps);
    precise real span = last_place - first_place;
    int first = min(max(int(first_place), 0), tick_series_steps - 1);
    int last = min(max(int(last_place), first), tick_series_steps - 1);
    int base = table * tick_series_points;
    if (last == first || !(span > real(0))) return load_tick_series(base + first);
    // By what each step has more than the first one.
    real even = load_tick_series(base + first);
    real2 sum = real2(real(0), real(0));
    for (int step = first + 1; step <= last; ++step) {
        precise real part = (step == last ? last_place - real(step) : real(1)) * (load_tick_series(base + step) - even);
        sum = add_increment(sum, part);
    }
    precise real mean = even + sum.x / span;
    return mean;
}
