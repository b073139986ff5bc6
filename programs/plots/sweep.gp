# How many equilibria, over a grid of two parameters; and the curves at which the number changes.
# Given: $points (x y real, -1 where nothing was counted), $folds, $pitchforks, $cusps (as bifurcation_locus), x_low,
# x_high, y_low, y_high (with half a cell around the grid), x_name, y_name, most (the largest number), least, counts (those that occur, a space before and after each).
set xrange [x_low:x_high]
set yrange [y_low:y_high]
set xlabel x_name
set ylabel y_name
set tics out nomirror
set border lw 1
set key outside right top Left reverse samplen 1.5 title 'equilibria' left
set style line 1 lc rgb '#202020' lw 1.6
# pale to dark, told apart in grey too
colour(n) = n < 0 ? 0xffffff : n <= 4 ? 0xf3efe0 : n <= 6 ? 0xc9dfc9 : n <= 8 ? 0x9cc9d0 : n <= 10 ? 0x6fa8cf : \
    n <= 12 ? 0x4d7fc0 : n <= 14 ? 0x3f58a5 : n <= 16 ? 0x372f7d : n <= 32 ? 0x1d1147 : 0x000000
part(n, by) = int(colour(n) / by) % 256
count(n) = sprintf('%d', n)
there(n) = strstrt(counts, sprintf(' %d ', n)) > 0
plot $points using 1:2:(part($3, 65536)):(part($3, 256)):(part($3, 1)) with rgbimage notitle, \
    for [n = least:most] there(n) ? NaN : 1 / 0 with points pt 5 ps 1.6 lc rgb colour(n) title (there(n) ? count(n) : ''), \
    $folds using 1:2 with lines ls 1 title 'folds', \
    $pitchforks using 1:2 with lines ls 1 dt (6, 4) title 'pitchforks', \
    $cusps using 1:2 with points pt 7 ps 0.7 lc rgb '#202020' title 'cusps'
