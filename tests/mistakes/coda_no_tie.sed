# stage5_asm/coda.c: gates: coda: every promise holds: half size
# On a border of two texels the last bit decides.
s|0\.5 + 1\.0 / 2097152|0.5|
