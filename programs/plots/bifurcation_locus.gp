# A bifurcation locus in a plane of two parameters, with the number of equilibria in each region, and insets around cusps.
# Given: heading, x_label, y_label, x_low, x_high, y_low, y_high; $folds, $pitchforks, $cusps, $infinite (from_infinity
#   says of how many curves);
#   labels, arrays label_text, label_x, label_y, label_size: what is written into the regions;
#   insets (0 to 2) and arrays for them: frame_x_low .. frame_y_high, where the frame is drawn; box_x_low .. box_y_high,
#   what the inset shows; inset_title; the tics of its axes: x_format, x_step, x_zero (1: a bare 0 at 0), and of y.
set multiplot title heading
set tics out nomirror
set border 31 lw 0.8
set key at screen 0.5,0.02 center bottom horizontal samplen 2.5
set xlabel x_label
set ylabel y_label rotate by 0
set lmargin at screen 0.09
set rmargin at screen (insets > 0 ? 0.64 : 0.96)
set bmargin at screen 0.16
set tmargin at screen 0.92
do for [k=1:labels] {
    set label label_text[k] at label_x[k],label_y[k] center font sprintf(',%d', label_size[k])
}
letters = 'ab'
do for [k=1:insets] {
    set object k rectangle from frame_x_low[k],frame_y_low[k] to frame_x_high[k],frame_y_high[k] \
        front fillstyle empty border lc rgb 'gray40' lw 0.8
    set label letters[k:k] at frame_x_low[k],frame_y_high[k] left offset 0.2,0.8 font ',13' tc rgb 'gray30'
}
if (from_infinity > 0) {
    plot [x_low:x_high][y_low:y_high] $pitchforks with lines lw 1.8 lc rgb '#0072b2' title 'pitchforks', \
        $folds with lines lw 2.2 lc rgb '#d55e00' title 'folds', \
        $infinite with lines lw 2.2 dt 2 lc rgb 'gray40' title 'from infinity', \
        $cusps with points pt 7 ps 0.9 lc rgb 'black' title 'cusps'
} else {
    plot [x_low:x_high][y_low:y_high] $pitchforks with lines lw 1.8 lc rgb '#0072b2' title 'pitchforks', \
        $folds with lines lw 2.2 lc rgb '#d55e00' title 'folds', \
        $cusps with points pt 7 ps 0.9 lc rgb 'black' title 'cusps'
}
unset object
unset label
unset xlabel
unset ylabel
unset key
set lmargin at screen 0.75
set rmargin at screen 0.97
set tics font ',11'
do for [k=1:insets] {
    top = insets == 1 ? 0.72 : k == 1 ? 0.87 : 0.45
    set tmargin at screen top
    set bmargin at screen top - (insets == 1 ? 0.36 : 0.29)
    set label 1 letters[k:k].': '.inset_title[k] at graph 0.5,1.07 center font ',12'
    set format x x_format[k]
    set xtics x_step[k]
    if (x_zero[k]) { set xtics add ('0' 0) }
    set format y y_format[k]
    set ytics y_step[k]
    if (y_zero[k]) { set ytics add ('0' 0) }
    plot [box_x_low[k]:box_x_high[k]][box_y_low[k]:box_y_high[k]] \
        $pitchforks with lines lw 1.8 lc rgb '#0072b2' title 'pitchforks', \
        $folds with lines lw 2.2 lc rgb '#d55e00' title 'folds', \
        $cusps with points pt 7 ps 0.9 lc rgb 'black' title 'cusps'
}
unset multiplot
