# For gdb: prints what the four lanes of stage 5 hold, by meaning. See stage5_asm/README.md.
#   gdb -x tests/lessons/lanes.gdb --args build/debug/texmap render --stage 5 ... -o 5.png

set breakpoint pending on

define start-of-segments
  printf "            lane 0      lane 1      lane 2      lane 3\n"
  printf "1/z start %10g  %10g  %10g  %10g\n", $xmm4.v4_float[0], $xmm4.v4_float[1], $xmm4.v4_float[2], $xmm4.v4_float[3]
  printf "1/z end   %10g  %10g  %10g  %10g\n", $xmm5.v4_float[0], $xmm5.v4_float[1], $xmm5.v4_float[2], $xmm5.v4_float[3]
  printf "u start   %10g  %10g  %10g  %10g\n", $xmm0.v4_float[0], $xmm0.v4_float[1], $xmm0.v4_float[2], $xmm0.v4_float[3]
  printf "u end     %10g  %10g  %10g  %10g\n", $xmm2.v4_float[0], $xmm2.v4_float[1], $xmm2.v4_float[2], $xmm2.v4_float[3]
end
document start-of-segments
While a group is set up: the lanes' interpolants, or u once it is divided, 65536 times as large.
end

define lanes
  set $width = 1 << (32 - $xmm12.v4_int32[0])
  printf "            lane 0      lane 1      lane 2      lane 3\n"
  set $scale = $width / 4294967296.0
  set $u = $xmm0.v4_int32
  printf "u         %10.4f  %10.4f  %10.4f  %10.4f\n", (unsigned)$u[0] * $scale, (unsigned)$u[1] * $scale, (unsigned)$u[2] * $scale, (unsigned)$u[3] * $scale
  set $v = $xmm1.v4_int32
  printf "v         %10.4f  %10.4f  %10.4f  %10.4f\n", $v[0] / 65536.0, $v[1] / 65536.0, $v[2] / 65536.0, $v[3] / 65536.0
  printf "pixels    %10d  %10d  %10d  %10d\n", $ebx, $ebp, $r11d, $edx
end
document lanes
While pixels are drawn: u and v of each lane's next pixel, with the half and the tie, and how many
pixels it has.
end
