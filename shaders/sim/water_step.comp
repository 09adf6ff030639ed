// Begins a sub-step of water: its length from the fastest wave, and the list of the tiles that have work. One group,
// because a dispatch costs more than this work. After the tick's time is over it lists none and leaves the marks.
layout(local_size_x = 256) in;
#include "sim/tile_samples.glsl"
#include "sim/water_images.glsl"

layout(std430) coherent buffer WaterActivity { uint water_activity[]; };
#include "sim/water_activity.glsl"
layout(std430) buffer TileList { uint list_arguments[4]; uint listed_tiles[]; };
layout(std430) buffer TileSpeeds { uint tile_speeds[]; };
layout(std430) readonly buffer Springs { vec4 springs[]; };        // column, row, m/s
layout(std430) readonly buffer TickSeries { float tick_series[]; };  // of maths/tick_series.glsl

#include "maths/edge_kinds.glsl"
#include "maths/two_sum.glsl"
real load_tick_series(int at) { return tick_series[at]; }
#include "maths/water_step.glsl"

shared uint fastest;
shared uint listed;
shared bool running;

// Whether the tile's water is active within reach of what lies to these sides of it.
bool is_wet(int2 tile, uint sides) {
    if (any(lessThan(tile, int2(0))) || any(greaterThanEqual(tile, tiles))) return false;
    return (water_activity[tile.y * tiles.x + tile.x] & sides) == sides;
}

bool has_work(int2 tile) {
    return is_wet(tile, wet) || is_wet(tile + int2(0, -1), wet_south) || is_wet(tile + int2(0, 1), wet_north) ||
           is_wet(tile + int2(-1, 0), wet_east) || is_wet(tile + int2(1, 0), wet_west) ||
           is_wet(tile + int2(-1, -1), wet_south | wet_east) || is_wet(tile + int2(1, -1), wet_south | wet_west) ||
           is_wet(tile + int2(-1, 1), wet_north | wet_east) || is_wet(tile + int2(1, 1), wet_north | wet_west);
}

// Edges of these kinds wake their tiles.
bool drives(int kind) {
    return kind == edge_inflow_kind || kind == edge_wave || (level_moves == 1 && kind == edge_level);
}

bool is_driven(int2 tile) {
    return (drives(edge_kind_north) && tile.y == 0) || (drives(edge_kind_south) && tile.y == tiles.y - 1) ||
           (drives(edge_kind_west) && tile.x == 0) || (drives(edge_kind_east) && tile.x == tiles.x - 1);
}

void main() {
    int me = int(gl_LocalInvocationIndex);
    int count = tiles.x * tiles.y;
    if (me == 0) {
        fastest = clock_edge_fastest;
        listed = 0u;
        running = clock_left_s > real(0);
    }
    barrier();
    if (running) {
        uint mine = 0u;
        for (int index = me; index < count; index += 256) {
            mine = max(mine, tile_speeds[index]);
            if (is_driven(int2(index % tiles.x, index / tiles.x))) water_activity[index] |= wet_all;
        }
        atomicMax(fastest, mine);
        for (int i = me; i < spring_count; i += 256) {
            int2 tile = int2(springs[i].xy) / tile_samples;
            atomicOr(water_activity[tile.y * tiles.x + tile.x], wet_all);
        }
    }
    memoryBarrierBuffer();
    barrier();
    if (running) {
        for (int index = me; index < count; index += 256) {
            int2 tile = int2(index % tiles.x, index / tiles.x);
            if (every_tile != 0 || has_work(tile)) {
                listed_tiles[atomicAdd(listed, 1u)] = uint(index);
                tile_speeds[index] = 0u;
            }
        }
    }
    barrier();
    if (running)
        for (int index = me; index < count; index += 256) water_activity[index] = 0u;
    if (me == 0) {
        list_arguments[0] = uint(tile_strips);
        list_arguments[1] = listed;
        list_arguments[2] = 1u;
        clock_dt_s = real(0);
        if (running) {
            real speed = uintBitsToFloat(fastest);
            WaterSubstep next = water_next_substep(clock_left_s, speed);
            clock_dt_s = next.dt;
            clock_left_s = next.left;
            clock_share_x = next.share.x;
            clock_share_y = next.share.y;
            clock_drain = next.drain;
            clock_friction = next.friction;
            clock_at = next.at;
            clock_share = next.part;
            clock_rain = next.rain;
            clock_inflow = next.inflow;
            clock_fastest = speed;
            clock_edge_fastest = 0u;
            total_substeps += 1.0lf;
            total_listed += double(listed);
            // A single product needs no `precise`. Here it would make the reference compiler hang (glslang 12.0).
            real rain = next.rain * next.dt;
            if (rain_is_mapped == 0) book_rain_m += double(water_eulers) * double(rain);
        }
    }
}
