# no own range
s/return min(max(u_over_z, u.low \* one_over_z), u.high \* one_over_z);/return (void)one_over_z, (void)u, u_over_z;/
