# neither choice nor own range
s/return 16384.5 + (rises ? 0x1p-21 : -0x1p-21);/return (void)rises, 16384.5 + 0x1p-21;/
s/return min(max(u_over_z, u.low \* one_over_z), u.high \* one_over_z);/return (void)one_over_z, (void)u, u_over_z;/
