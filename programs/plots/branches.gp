# A parameter of a structure over a measure along its branches; stable parts are heavier.
# Given: heading, measure, parameter; $stable, $unstable: pieces; $folds, $bifurcations: points.
set tics out nomirror
set border 31 lw 0.8
set key outside right top samplen 2
set title heading
set xlabel measure
set ylabel parameter
plot $unstable with lines lw 1.2 lc rgb '#e69f00' title 'unstable', \
    $stable with lines lw 2.4 lc rgb '#009e73' title 'stable', \
    $bifurcations with points pt 7 ps 0.8 lc rgb '#0072b2' title 'bifurcations', \
    $folds with points pt 5 ps 0.8 lc rgb 'black' title 'folds'
