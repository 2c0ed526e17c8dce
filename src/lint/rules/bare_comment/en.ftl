S502 = a comment on a line of its own begins with `0`
    .fix = put `0` in front
