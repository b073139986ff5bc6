# A measure of a field's solutions over the parameter, stable parts heavier; beside it the profiles at some folds.
# Given: heading, measure, parameter; $stable, $unstable: pieces; $folds, $bifurcations: points; shown: how many profiles,
# maybe 0; bifurcations: their number; $marks: a letter for each profile, and where it stands; $profiles: x and u, one index
# each.
set tics out nomirror
set border 3 lw 0.8
if (shown > 0) set multiplot layout 1, 2
if (shown > 0) set rmargin at screen 0.56
set key inside left top samplen 2 height 0.3
set title heading
set xlabel parameter
set ylabel measure
set offsets graph 0.04, graph 0.04, graph 0.12, graph 0.03
pieces = "plot $unstable with lines lw 1.2 lc rgb '#e69f00' title 'unstable', \
    $stable with lines lw 2.4 lc rgb '#009e73' title 'stable', \
    $folds with points pt 5 ps 0.5 lc rgb 'black' title 'folds'"
if (bifurcations > 0) pieces = pieces . ", $bifurcations with points pt 7 ps 0.7 lc rgb '#0072b2' title 'bifurcations'"
if (shown > 0) pieces = pieces . ", $marks using 1:2:3 with labels notitle"
eval pieces
if (shown > 0) {
    set lmargin at screen 0.64
    set rmargin at screen 0.97
    unset key
    set title 'u at the folds'
    set xlabel 'x'
    unset ylabel
    unset ytics
    set border 1 lw 0.8
    stats $profiles using 2 nooutput
    gap = 1.15 * (STATS_max - STATS_min)
    stats $profiles using 1 nooutput
    left = STATS_min
    right = STATS_max
    set offsets 0, 0, 0, 0
    set xrange [left : right + 0.1 * (right - left)]
    set yrange [-(shown - 1) * gap - 0.6 * gap : 0.7 * gap]
    plot for [k = 0 : shown - 1] -k * gap with lines lw 0.5 dt 3 lc rgb '#888888' notitle, \
        for [k = 0 : shown - 1] $profiles index k using 1:($2 - k * gap) with lines lw 1.6 lc rgb '#0072b2' notitle, \
        for [k = 0 : shown - 1] $marks using (right + 0.05 * (right - left)):(-k * gap):3 every ::k::k with labels notitle
    unset multiplot
}
