# Where motions from rest end.
# Given: $basins: q1, q2, and which equilibrium (-1: none); $index0, $index1, $index2: equilibria.
set title 'Where motions from rest end: {/:Italic F} = 0, {/:Italic c}_2 = 50 N/m'
set size ratio 1
unset colorbox
set palette defined (-1 '#888888', 0 '#fdd49e', 1 '#9ecae1')
set cbrange [-1:1]
set xtics ('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)
set ytics ('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)
set tics out nomirror
set border 31 lw 0.8
set xlabel '{/:Italic q}_1'
set ylabel '{/:Italic q}_2' rotate by 0
set key below horizontal samplen 1
plot [-pi:pi][-pi:pi] $basins using 1:2:3 with image notitle, \
    $index0 with points pt 7 ps 1.4 lc rgb '#009e73' title 'index 0 (stable)', \
    $index1 with points pt 7 ps 1.4 lc rgb '#e69f00' title 'index 1', \
    $index2 with points pt 7 ps 1.4 lc rgb '#cc3311' title 'index 2'
