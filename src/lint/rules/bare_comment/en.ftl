S502 = a comment of its own is introduced by `0`
    .fix = put `0` in front
