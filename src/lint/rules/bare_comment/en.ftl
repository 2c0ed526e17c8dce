S502 = a comment on a line of its own must begin with `0`
    .fix = put `0` in front
