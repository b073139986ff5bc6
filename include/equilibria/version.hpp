/// \file
/// The version of equilibria. It is written here and nowhere else: CMake reads this file.
#pragma once

/// The three numbers of the version, x.y.z.
/// \{
#define EQUILIBRIA_VERSION_MAJOR 0
#define EQUILIBRIA_VERSION_MINOR 1
#define EQUILIBRIA_VERSION_PATCH 0
/// \}

/// \cond
// Two steps, so that the numbers and not the macros' names become text.
#define EQUILIBRIA_DETAIL_DOTTED(a, b, c) #a "." #b "." #c
#define EQUILIBRIA_DETAIL_VERSION(a, b, c) EQUILIBRIA_DETAIL_DOTTED(a, b, c)
/// \endcond

/// The version as text, "x.y.z".
#define EQUILIBRIA_VERSION_STRING \
    EQUILIBRIA_DETAIL_VERSION(EQUILIBRIA_VERSION_MAJOR, EQUILIBRIA_VERSION_MINOR, EQUILIBRIA_VERSION_PATCH)
