# The bifurcation loci of the two-link chain at several ratios: a panel for each, all with the same axes, a key for all.
# Given: height (of the picture, in pixels); x_low, x_high, y_low, y_high; planes and for each of them panel_title,
#   panel_left, panel_right, panel_top, panel_bottom (parts of the picture), lowest, leftmost (1: with tics and name of
#   the axis), and, counted from 0, $folds0, $pitchforks0, $cusps0, ..; labels and for each of them label_plane (from 1),
#   label_text, label_x, label_y.
set multiplot
set tics out nomirror font ',11'
set border 31 lw 0.8
unset key
set label 1 'Bifurcation loci of the rotating two-link chain, {/:Italic r} = {/:Italic l}_2 / {/:Italic l}_1' \
    at screen 0.5,1 - 28 / height center font ',16'
do for [k=1:planes] {
    set lmargin at screen panel_left[k]
    set rmargin at screen panel_right[k]
    set tmargin at screen panel_top[k]
    set bmargin at screen panel_bottom[k]
    set title panel_title[k] offset 0,-0.6 font ',13'
    if (lowest[k]) {
        set format x '%g'
        set xlabel '{/:Italic α} = {/:Italic m}_2 / ({/:Italic m}_1 + {/:Italic m}_2)'
    } else {
        set format x ''
        unset xlabel
    }
    if (leftmost[k]) {
        set format y '%g'
        set ylabel '{/:Italic ω}' rotate by 0
    } else {
        set format y ''
        unset ylabel
    }
    do for [j=1:labels] {
        if (label_plane[j] == k) {
            set label label_text[j] at label_x[j],label_y[j] center font ',12' tc rgb 'gray30'
        }
    }
    eval(sprintf("plot [x_low:x_high][y_low:y_high] $pitchforks%d with lines lw 1.6 lc rgb '#0072b2', " \
        ."$folds%d with lines lw 2 lc rgb '#d55e00', $cusps%d with points pt 7 ps 0.7 lc rgb 'black'", k-1, k-1, k-1))
    unset label
}
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 84 / height
unset border
unset tics
unset title
unset xlabel
unset ylabel
set label 'numbers: equilibria' at screen 0.5,16 / height center font ',12' tc rgb 'gray30'
set key center center horizontal Left reverse samplen 2.5
plot [0:1][0:1] NaN with lines lw 1.6 lc rgb '#0072b2' title 'pitchforks', \
    NaN with lines lw 2 lc rgb '#d55e00' title 'folds', NaN with points pt 7 ps 0.7 lc rgb 'black' title 'cusps'
unset multiplot
