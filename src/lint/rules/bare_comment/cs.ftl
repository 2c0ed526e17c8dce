S502 = před komentářem na samostatném řádku má být `0`
    .fix = napsat před něj `0`
