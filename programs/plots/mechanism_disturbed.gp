# A disturbed motion beside the linearised one: a panel for each angle.
# Given: heading, end (of the time), span; $motion, $linear: time, deviations of q1 and q2.
set multiplot layout 1,2 title heading margins 0.08,0.98,0.22,0.88 spacing 0.1
set tics out nomirror
set border 31 lw 0.8
set grid lc rgb '#dddddd'
set xlabel '{/:Italic t} [s]'
set key at screen 0.5,0.03 center bottom horizontal maxrows 1 samplen 2
do for [angle=1:2] {
    set ylabel sprintf('deviation of {/:Italic q}_%d [rad]', angle)
    plot [0:end][-span:span] \
        $motion using 1:angle+1 with lines lw 2.4 lc rgb '#0072b2' title 'equations of motion', \
        $linear using 1:angle+1 with lines lw 1.6 dt 2 lc rgb '#cc3311' title 'linearised'
    unset key
}
unset multiplot
