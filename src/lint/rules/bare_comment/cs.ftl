S502 = samostatný komentář se uvádí záznamem `0`
    .fix = napsat před něj `0`
