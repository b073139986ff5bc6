# A structure's branches at the left, its shapes along them at the right.
# Given: heading, component (of the watched node), parameter; $stable, $unstable, $folds, $bifurcations;
#   in_space (1: else all is in the plane of x and y), tic; $initial and shapes, rows x, z, y: main_shapes of the main
#   branch, $shape0x1, $shape0x2, .., and side_shapes of the first that leaves it, $shape1x1, ..
set multiplot title heading
set tics out nomirror
set border 31 lw 0.8
set bmargin at screen 0.22
set tmargin at screen 0.9
set lmargin at screen 0.09
set rmargin at screen 0.47
set key at screen 0.28,0.01 center bottom horizontal maxrows 2 samplen 2
set xlabel '{/:Italic '.component.'} of the watched node'
set ylabel parameter
plot $unstable with lines lw 1.2 lc rgb '#e69f00' title 'unstable', \
    $stable with lines lw 2.4 lc rgb '#009e73' title 'stable', \
    $bifurcations with points pt 7 ps 0.8 lc rgb '#0072b2' title 'bifurcations', \
    $folds with points pt 5 ps 0.8 lc rgb 'black' title 'folds'
set key at screen 0.77,0.03 center bottom horizontal maxrows 1
set lmargin at screen 0.56
set rmargin at screen 0.97
unset ylabel
unset xlabel
columns = in_space ? '' : ' using 1:3'
curves = '$initial'.columns." with lines lw 2.4 lc rgb '#888888' title 'without load'"
do for [k=1:main_shapes] {
    curves = curves.sprintf(', $shape0x%d', k).columns." with lines lw 1.6 lc rgb '#009e73' " \
        .(k == 1 ? "title 'main branch'" : 'notitle')
}
do for [k=1:side_shapes] {
    curves = curves.sprintf(', $shape1x%d', k).columns." with lines lw 1.6 lc rgb '#e69f00' " \
        .(k == 1 ? "title 'side branch'" : 'notitle')
}
if (in_space) {
    set view 75,335
    set view equal xyz
    set xyplane relative 0
    set xlabel '{/:Italic x}' offset 0,-1
    set ylabel '{/:Italic z}' offset -1,-1
    set zlabel '{/:Italic y}'
    set xtics tic offset 0,-0.4
    set ytics tic offset -0.5,-0.6
    set ztics tic offset 0,0.4
    eval('splot '.curves)
} else {
    set size ratio -1
    set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
    eval('plot '.curves)
}
unset multiplot
