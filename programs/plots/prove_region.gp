# Cells in which the number of equilibria of the two-link chain is proved, under the curves of its locus.
# Given: ratio, share (of the area, proved, in per cent), x_low, x_high, y_low, y_high; counts: the numbers of
# equilibria, a word each; $cells: a data set for each of them, centre and bounds of cells; $folds, $pitchforks.
colours = '#dbe9f6 #cdebd5 #fdf2c0 #fbdcc0 #e6d7ee #f6cfd8 #d9d9d9 #bfe3e0'
set title sprintf('Equilibria proved: %.2f %% of the window, {/:Italic l}_2 / {/:Italic l}_1 = %.10g', share, ratio)
set tics out nomirror
set border 31 lw 0.8
set key outside right top title 'equilibria' samplen 2
set xlabel '{/:Italic α} = {/:Italic m}_2 / ({/:Italic m}_1 + {/:Italic m}_2)'
set ylabel '{/:Italic ω}' rotate by 0
plot [x_low:x_high][y_low:y_high] \
    for [k=1:words(counts)] $cells index k-1 with boxxyerror fillstyle solid 1 noborder \
        lc rgb word(colours, (k - 1) % words(colours) + 1) title word(counts, k), \
    $pitchforks with lines lw 1.4 lc rgb '#0072b2' title 'pitchforks', \
    $folds with lines lw 1.6 lc rgb '#d55e00' title 'folds'
