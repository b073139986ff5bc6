# The potential over both angles, the curves on which each equation holds, and the equilibria by index.
# Given: force; grids of q1, q2 and a value: $surface, $map (the potential), $equation1, $equation2; $index0, $index1,
# $index2: angles and energies.
set contour base
unset surface
set cntrparam levels discrete 0
set table $zero1
splot $equation1 with lines
unset table
set table $zero2
splot $equation2 with lines
unset table
unset contour
set surface
set multiplot title sprintf('Potential energy of the mechanism, {/:Italic F} = %g N', force)
set palette defined (0 '#253494', 1 '#41b6c4', 2 '#ffffcc')
set xtics ('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)
set ytics ('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)
set xlabel '{/:Italic q}_1'
set ylabel '{/:Italic q}_2'
set tics out nomirror
unset colorbox
set origin 0,0.06
set size 0.5,0.9
set key at screen 0.25,0.03 center bottom horizontal maxrows 1 samplen 1
set view 32,335,1.1,1
set xyplane relative 0.05
set zlabel '{/:Italic V} [J]' rotate by 90 offset 1,0
set ztics 500
set border 31 lw 0.5
splot [-pi:pi][-pi:pi] $surface using 1:2:3 with pm3d notitle, \
    $index0 using 1:2:3 with points pt 7 ps 1.3 lc rgb '#009e73' title 'index 0 (stable)', \
    $index1 using 1:2:3 with points pt 7 ps 1.3 lc rgb '#e69f00' title 'index 1', \
    $index2 using 1:2:3 with points pt 7 ps 1.3 lc rgb '#cc3311' title 'index 2'
set border 31 lw 0.8
set ylabel '{/:Italic q}_2' rotate by 0
set origin 0.5,0.06
set size 0.5,0.9
set key at screen 0.75,0.03 center bottom horizontal maxrows 1 samplen 2
set colorbox
set cblabel '{/:Italic V} [J]'
set size ratio 1
plot [-pi:pi][-pi:pi] $map using 1:2:3 with image notitle, \
    $zero1 using 1:2 with lines lw 2 lc rgb '#000000' title '∂{/:Italic V}/∂{/:Italic q}_1 = 0', \
    $zero2 using 1:2 with lines lw 2 lc rgb '#d55ebc' title '∂{/:Italic V}/∂{/:Italic q}_2 = 0', \
    $index0 using 1:2 with points pt 7 ps 1.6 lc rgb 'white' notitle, \
    $index0 using 1:2 with points pt 7 ps 1.1 lc rgb '#009e73' notitle, \
    $index1 using 1:2 with points pt 7 ps 1.6 lc rgb 'white' notitle, \
    $index1 using 1:2 with points pt 7 ps 1.1 lc rgb '#e69f00' notitle, \
    $index2 using 1:2 with points pt 7 ps 1.6 lc rgb 'white' notitle, \
    $index2 using 1:2 with points pt 7 ps 1.1 lc rgb '#cc3311' notitle
unset multiplot
