"""The figures and Table 1 of the paper: what it states, the runs behind it, the pictures, and how they are judged."""
