# The equilibria of a model against a parameter: a panel for each unknown.
# Given: heading, x_label, low, high; unknowns, array labels; angles (the first so many unknowns are angles); $stable,
#   $unstable, $folds, $others: the parameter, then each unknown.
columns = unknowns < 3 ? unknowns : 3
rows = (unknowns + columns - 1) / columns
set multiplot layout rows,columns title heading margins screen 0.02 + 0.10 / columns, 0.98, 0.02 + 0.2 / rows, 1 - 0.09 / rows \
    spacing screen 0.13 / columns + 0.03, 0.16 / rows
set tics out nomirror
set border 31 lw 0.8
set xlabel x_label
set key at screen 0.5,0.02 center bottom horizontal maxrows 1 samplen 2
do for [u=1:unknowns] {
    set label 1 labels[u] at graph -0.03, graph 1.04 right
    if (u <= angles) {
        set ytics ('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)
        set yrange [-3.4:3.4]
    } else {
        set ytics autofreq
        set yrange [*:*]
    }
    plot [low:high] $unstable using 1:u+1 with lines lw 1.4 dt (6, 4) lc rgb '#cc3311' title 'unstable', \
        $stable using 1:u+1 with lines lw 2.4 lc rgb '#009e73' title 'stable', \
        $others using 1:u+1 with points pt 7 ps 0.7 lc rgb '#0072b2' title 'bifurcations', \
        $folds using 1:u+1 with points pt 5 ps 0.7 lc rgb 'black' title 'folds'
    unset key
}
unset multiplot
