# Relative equilibria of the body with a beam against the angular momentum, by index: a panel for each strain energy.
# Given: low, high (of the momentum); for the linear (0) and the coupled (1) strain $b<strain><index>, pieces of
# branches; $p<strain>, pitchforks; $f<strain>, folds; $t<strain>, the beam cut down to two modes.
set tics out nomirror
set border 31 lw 0.8
set multiplot layout 1,2 margins 0.075,0.985,0.235,0.92 spacing 0.08
set xlabel 'angular momentum |{/:Bold a}| / {/:Italic l}({/:Italic ρμ}_1)^{1/2}'
set ylabel 'moment of inertia about the axis {/:Italic λ} / {/:Italic ρl}^{3}'
unset key
set title '(a) linear strain'
plot [low:high][0.65:2.2] $t0 with lines lw 1.6 dt (1,3) lc rgb '#555555', \
    $b03 with lines lw 1.8 dt (2,3) lc rgb '#cc79a7', $b02 with lines lw 1.8 dt (5,4) lc rgb '#0072b2', \
    $b01 with lines lw 1.8 dt (9,4) lc rgb '#e69f00', $b00 with lines lw 2.6 dt 1 lc rgb '#009e73', \
    $p0 with points pt 7 ps 0.8 lc rgb 'black', $f0 with points pt 9 ps 1 lc rgb '#d55e00'
set title '(b) coupled strain'
plot [low:high][0.65:3.2] $t1 with lines lw 1.6 dt (1,3) lc rgb '#555555', \
    $b13 with lines lw 1.8 dt (2,3) lc rgb '#cc79a7', $b12 with lines lw 1.8 dt (5,4) lc rgb '#0072b2', \
    $b11 with lines lw 1.8 dt (9,4) lc rgb '#e69f00', $b10 with lines lw 2.6 dt 1 lc rgb '#009e73', \
    $p1 with points pt 7 ps 0.8 lc rgb 'black', $f1 with points pt 9 ps 1 lc rgb '#d55e00'
# the key: a picture of its own
unset title
unset xlabel
unset ylabel
unset tics
unset border
set key at screen 0.53,0.045 center horizontal maxrows 1 samplen 3
set margins 0,0,0,0
set size 1,0.08
set origin 0,0
plot [0:1][0:1] NaN with lines lw 2.6 dt 1 lc rgb '#009e73' title 'stable', \
    NaN with lines lw 1.8 dt (9,4) lc rgb '#e69f00' title 'index 1', \
    NaN with lines lw 1.8 dt (5,4) lc rgb '#0072b2' title 'index 2', \
    NaN with lines lw 1.8 dt (2,3) lc rgb '#cc79a7' title 'index 3, 4', \
    NaN with points pt 7 ps 0.8 lc rgb 'black' title 'pitchfork', \
    NaN with points pt 9 ps 1 lc rgb '#d55e00' title 'fold', \
    NaN with lines lw 1.6 dt (1,3) lc rgb '#555555' title 'two modes, whirling'
unset multiplot
