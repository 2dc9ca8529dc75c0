#!/bin/sh
# actividad3.sh PROGRAM DATA OUT: solves every problem of DATA, one a line. Shows its analysis and first rows; writes its whole
# table to OUT.
set -e
program=$1 data=$2 out=$3
mkdir -p "$out"

n=0
sed 's/#.*//' "$data" | while read -r dt every until theta0 theta_unit omega0 omega_unit alpha; do
    [ -n "$dt" ] || continue
    n=$((n + 1))
    table=$out/problem_$n.txt
    echo "$dt $every $until $theta0 $theta_unit $omega0 $omega_unit $alpha" | "$program" >"$table"
    echo "Problem $n: theta0 = $theta0 $theta_unit, omega0 = $omega0 $omega_unit, alpha = $alpha"
    echo "k thetaM tau: $(echo "$theta0 $theta_unit $omega0 $omega_unit $alpha" | "$program" analyze)"
    head -n 6 "$table"
    echo "... $(wc -l <"$table") lines in $table"
    echo
done
