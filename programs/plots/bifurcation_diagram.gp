# The equilibria of the two-link chain against omega, by index: a panel for each angle.
# Given: ratio, alpha, low, high (of omega); $index0, $index1, $index2, $folds, $pitchforks: omega, theta_1, theta_2.
set multiplot title sprintf('Equilibria of the rotating two-link chain, {/:Italic l}_2 / {/:Italic l}_1 = %.10g, {/:Italic α} = %.10g', ratio, alpha)
set tics out nomirror
set border 31 lw 0.8
set xlabel '{/:Italic ω}'
set ytics ('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)
set bmargin at screen 0.22
set tmargin at screen 0.9
set key at screen 0.5,0.02 center bottom horizontal maxrows 1 samplen 2
do for [angle=1:2] {
    set lmargin at screen (angle == 1 ? 0.11 : 0.6)
    set rmargin at screen (angle == 1 ? 0.49 : 0.98)
    set ylabel sprintf('{/:Italic θ}_%d', angle) rotate by 0
    plot [low:high][-3.4:3.4] $index0 using 1:angle+1 with lines lw 2.4 lc rgb '#009e73' title 'index 0 (stable)', \
        $index1 using 1:angle+1 with lines lw 1.6 lc rgb '#e69f00' title 'index 1', \
        $index2 using 1:angle+1 with lines lw 1.6 lc rgb '#cc3311' title 'index 2', \
        $pitchforks using 1:angle+1 with points pt 7 ps 0.7 lc rgb '#0072b2' title 'pitchforks', \
        $folds using 1:angle+1 with points pt 5 ps 0.7 lc rgb 'black' title 'folds'
    unset key
}
unset multiplot
