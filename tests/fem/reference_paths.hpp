// Points of post-critical paths that both the shooting method and the finite elements must meet.
#pragma once

namespace references {

/// Of the elastica: the tip's angle in degrees, the load over the critical one, x and y of the tip.
inline constexpr double elastica[][4] = {{20, 1.01539686554, .969730907364, .219413042396},
                                         {60, 1.15171962047, .741019606076, .593207646165},
                                         {120, 1.88480086898, .123159972405, .803170990007}};

/// Of a cantilever that buckles sideways, EI3 = 25: z of the tip, the load over the critical one, x and y of the tip.
inline constexpr double lateral_critical_load = 4.9375453396;
inline constexpr double lateral_cantilever[][4] = {{.1, 1.010293788, .9895564, -.0747452},
                                                   {.2, 1.044597780, .9644797, -.1039196},
                                                   {.4, 1.300753866, .8189963, -.2674014}};

/// Of the right-angle frame: z of the tip and the load.
inline constexpr double right_angle_critical_load = 1.0875179377;
inline constexpr double right_angle_frame[][2] = {
    {10, 1.091579938}, {20, 1.104364521}, {40, 1.167728430}, {60, 1.437891246}};

/// Of the 45 degree bend: the load and the place of the tip.
inline constexpr double bend[][4] = {{300, 58.77912249, 22.24478095, 40.19189167},
                                     {450, 52.23855801, 18.50817893, 48.50292734},
                                     {600, 47.15043857, 15.68480053, 53.47485879}};

}  // namespace references
