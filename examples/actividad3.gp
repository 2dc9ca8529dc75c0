# The four problems of the assignment as one picture, from the tables that `make run` leaves in out/:
#   gnuplot -c examples/actividad3.gp docs/figures/actividad3.svg
set terminal svg size 960,400 dynamic font "sans-serif,13" background "white"
set output ARG1
set encoding utf8

array tau[4]  # each table ends at its tau
do for [i=1:4] {
    stats sprintf("out/problem_%d.txt", i) using 1 skip 1 nooutput
    tau[i] = STATS_max
}
# A line breaks where the angle is wrapped.
unbroken(x) = (jump = column(0) > 0 && abs(x - last) > 3, last = x, jump ? NaN : x)

set linetype 1 linecolor "#0072b2" linewidth 2
set linetype 2 linecolor "#d55e00" linewidth 2
set linetype 3 linecolor "#009e73" linewidth 2
set linetype 4 linecolor "#cc79a7" linewidth 2
set label 1 "90°, at rest" at screen 0.07,0.94 textcolor linetype 1
set label 2 "0, 1.999999895801368 rad/s" at screen 0.24,0.94 textcolor linetype 2
set label 3 "0, −2 rad/s" at screen 0.57,0.94 textcolor linetype 3
set label 4 "0, 2.01 rad/s" at screen 0.76,0.94 textcolor linetype 4
unset key
set border 3
set tics nomirror
set multiplot layout 1,2 margins 0.07,0.98,0.15,0.87 spacing 0.1

pi_tics = "set %stics ('−π' -pi, '−π/2' -pi/2, '0' 0, 'π/2' pi/2, 'π' pi)"
eval sprintf(pi_tics, "x")
eval sprintf(pi_tics, "y")
set xrange [-pi:pi]
set yrange [-2.5:2.5]
set xlabel "θ [rad]"
set ylabel "ω [rad/s]"
set ytics 1
last = 0
plot for [i=1:4] sprintf("out/problem_%d.txt", i) using (unbroken($2)):3 skip 1 with lines

unset for [i=1:4] label i
set xrange [0:1]
set yrange [-pi:pi]
set xlabel "t/τ"
set ylabel "θ [rad]"
set xtics 0.25
eval sprintf(pi_tics, "y")
last = 0
plot for [i=1:4] sprintf("out/problem_%d.txt", i) using ($1/tau[i]):(unbroken($2)) skip 1 with lines
unset multiplot
