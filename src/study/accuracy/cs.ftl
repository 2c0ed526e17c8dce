### Zpráva příkazu `zpg accuracy`.

accuracy-kind-edges = hrany
accuracy-kind-light = zanedbané světlo
accuracy-kind-numbers = zaokrouhlování
accuracy-kind-facets = plošky

accuracy-advice-none = Poradit nelze: žádné měření nebylo dokončeno.
accuracy-advice-wrong = Reference je chybná: nezávislý sledovač paprsků se 71 číslicemi dává jinou barvu v { $wrong } z { $pixels ->
    [one] { $pixels } pixelu
   *[other] { $pixels } pixelů
} (největší rozdíl { $largest }, kde bílá je 1, na místech { $places }). Proto tu není žádná rada. Nahlaste prosím tuto scénu.
accuracy-advice-unchecked = Referenci neověřil nezávislý sledovač paprsků: { $why }.
accuracy-advice-enough = Výchozí nastavení stačí: žádný druh chyby nedosahuje { $goal } { accuracy-goal-unit } osmibitového obrázku (největší: { $kind }, { $error }).
accuracy-advice-enough-of = Z toho, co se měřilo ({ $axes }), nedosahuje při výchozím nastavení nic { $goal } { accuracy-goal-unit } osmibitového obrázku (největší: { $kind }, { $error }). Jiné chyby se neměřily.
accuracy-goal-unit = kroku
accuracy-advice-limit = Největší chybu v tomto obrázku působí { $kind }: při výchozím nastavení se pixely odchylují o { $error } kroku (střední kvadratická odchylka). Krok je 1/255 bílé, nejmenší rozdíl, který osmibitový obrázek dokáže zobrazit.
accuracy-at-most = nejvýše { $error }
accuracy-advice-set = S `{ $option }` je tato chyba { $error } kroku a obrázek trvá { $times }krát déle než s výchozím nastavením.
accuracy-advice-dearer = S `{ $option }` je { $error } kroku, ale obrázek trvá { $times }krát déle.
accuracy-advice-even = I `{ $option }`, s nímž obrázek trvá { $times }krát déle než s výchozím nastavením, ponechá chybu { $error } kroku.
accuracy-advice-busy = Počítač byl na přesné měření času příliš zaneprázdněný: procesor používaly i jiné programy, takže běhy trvaly { $times }násobek svého času procesoru. Než se na časy spolehnete, ukončete tyto programy a měřte znovu.
accuracy-advice-others = Každý z ostatních druhů chyby je při výchozím nastavení menší než { $error } kroku.
accuracy-advice-others-of = Každý z ostatních druhů chyby, které se měřily, je při výchozím nastavení menší než { $error } kroku.
accuracy-price = za { $percent } % času navíc
accuracy-price-none = bez měřitelného času navíc
accuracy-price-unsure = za cenu, kterou se nepodařilo změřit
accuracy-advice-repair = Z { $pixels ->
    [one] { $pixels } prohlédnutého pixelu
   *[other] { $pixels } prohlédnutých pixelů
} se jich kvůli zanedbanému světlu liší { $off } o víc než krok. `{ $option }` jich opraví { $right } { $price }.
accuracy-advice-save = `{ $option }` ušetří { $percent } % času a žádný další pixel se neliší o víc než krok.
accuracy-advice-no-change = Žádné jiné nastavení příkazu `zpg render` neušetří desetinu času, aniž by to bylo vidět.
accuracy-depth-more = Výchozí hloubka { $depth } vynechává světlo, které by bylo vidět: `{ $option }` z { $off ->
    [one] { $off } pixelu
   *[other] { $off } pixelů
} opraví { $right } a obrázek trvá { $times }krát déle.
accuracy-depth-less = Výchozí hloubka { $depth } je víc než dost: `{ $option }` dává na pohled stejný obrázek a { $price }.
accuracy-depth-same = Výchozí hloubka { $depth } je víc než dost, ale menší neušetří žádný čas.
accuracy-depth-right = Výchozí hloubka { $depth } stačí a s menší se obrázek změní.
accuracy-numbers-same = Dvojitá přesnost tu stačí: double-double s dvojnásobným počtem číslic trvá { $times }krát déle a dává tentýž obrázek.
accuracy-numbers-unseen = Dvojitá přesnost na pohled stačí: double-double s dvojnásobným počtem číslic trvá { $times }krát déle a neopraví žádný pixel.
accuracy-numbers-untimed = Dvojitá přesnost nepokazí žádný pixel.
accuracy-numbers-report = Dvojitá přesnost se mýlí v { $off ->
    [one] { $off } pixelu
   *[other] { $off } pixelech
}: nahlaste prosím tuto scénu.
accuracy-numbers-f32 = Jednoduchá přesnost { $off ->
    [0] ukazuje totéž
    [one] pokazí { $off } pixel
    [few] pokazí { $off } pixely
   *[other] pokazí { $off } pixelů
} a { $price }.
accuracy-numbers-plain = Výpočet, který nehlídá vlastní zaokrouhlování, jak ho má většina sledovačů paprsků (`plain-f64`, pro srovnání), { $off ->
    [0] tu nepokazí nic
    [one] pokazí { $off } pixel
    [few] pokazí { $off } pixely
   *[other] pokazí { $off } pixelů
} a { $price }.
accuracy-saves-nothing = trvá stejně dlouho
accuracy-saves = ušetří { $percent } %
accuracy-costs = trvá o { $percent } % déle
accuracy-time-unsure = kolik času stojí, nelze říci

accuracy-skip-unasked = nebylo požadováno
accuracy-skip-light = nic nezrcadlí a nic nepropouští světlo: žádné světlo se nezanedbá
accuracy-skip-solver = nevykresluje se žádný torus ani rotační těleso
accuracy-skip-levels = nevykresluje se žádná geodetická koule
accuracy-skip-glass = něčím prochází světlo, a trojúhelník nemá vnitřek
accuracy-skip-flat = všechno je rovné
accuracy-skip-patterns = i vzory by se rozpadly na plošky
accuracy-skip-mesh = nešlo z ní udělat síť
accuracy-unfit-parts = má příliš mnoho částí
accuracy-unfit-deep = její operace jsou vnořeny příliš hluboko
accuracy-unfit-facets = geodetická koule má příliš mnoho plošek
accuracy-unfit-matrix = některá matice nemá inverzi

accuracy-how-naive = celé pixely proti nezávislému sledovači paprsků se 71 číslicemi
accuracy-how-light = poloviční hloubka a desetinásobný práh proti plnému výpočtu, na čtvrtině dlaždic
accuracy-how-edges = polovina vzorků proti všem
accuracy-cut-runs = některé z pěti běhů

accuracy-step-pilot = každé nastavení jednou na zkoušku
accuracy-step-numbers = reference v double-double a její ověření
accuracy-step-light = reference pro zanedbané světlo
accuracy-step-edges = reference pro hrany
accuracy-step-errors = chyby
accuracy-step-times = časy
accuracy-step-objects = objekty
accuracy-step-pictures = obrázky

accuracy-effect-shadows = stíny
accuracy-effect-transparent-shadows = průhledné stíny
accuracy-effect-reflection = zrcadlení
accuracy-effect-refraction = lom
accuracy-effect-dispersion = disperze
accuracy-effect-textures = textury
accuracy-effect-smooth-normals = hladké normály

accuracy-title = Kolik stojí přesnost
accuracy-stopped = Měření bylo zastaveno před koncem.
accuracy-columns = { "  " }   CPU  × výchozí     chyba     FLIP   o >1
accuracy-legend = ◆ výchozí nastavení
    ● stojí za svůj čas: žádné jiné vyzkoušené nastavení není zároveň rychlejší i přesnější
    ○ jiné nastavení je rychlejší a stejně přesné, nebo přesnější a v mezích šumu stejně rychlé
    CPU: čas celého obrázku na jednom vlákně. Chyba: střední kvadratická odchylka v krocích 1/255 bílé. FLIP: rozdíl, jak jej vnímá člověk, od 0 do 1. O >1: pixely, které se odchylují o více než krok.
    { $left ->
        [0] Jsou tu všechna vyzkoušená nastavení.
        [one] { $left } další nastavení je v accuracy.json.
        [few] { $left } další nastavení jsou v accuracy.json.
       *[other] { $left } dalších nastavení je v accuracy.json.
    }
accuracy-same = totéž
accuracy-note-columns = Chyba: střední kvadratická odchylka od reference v krocích 1/255. FLIP: jak velký rozdíl vnímá člověk, od 0 do 1. Pixely: ty, v nichž se některý kanál liší o víc než krok, a kolik jich bylo prohlédnuto; pomalá nastavení se měří na menším počtu. Největší: největší rozdíl v jednom kanálu. Na čele: nic z vyzkoušeného není zároveň rychlejší i přesnější. Adaptive: vzorky přibývají, dokud odhad chyby pixelu neklesne pod toto číslo. Cutoff: paprsky, které váží méně, se zanedbají. `plain-f32` a `plain-f64` jsou tu pro srovnání, stejně jako řešiče a sítě: `zpg render` taková nastavení nemá.
accuracy-note-objects = Kam jde čas a kde je chyba. Pixel se počítá k tomu, co vidí jeho střed.
accuracy-note-effects = Co stojí jednotlivé efekty. Vypínají se po jednom; překrývají se, takže součet podílů není celek.
accuracy-background = pozadí
accuracy-time-by = čas podle toho, co je vidět
accuracy-error-by = chyba podle toho, co je vidět
accuracy-taken-out = čas efektů (překrývají se)
accuracy-nothing = Není co porovnávat · { $why }
accuracy-not-run = neměřeno
accuracy-cut = vynecháno kvůli času
accuracy-noise = časy jsou jisté na ±{ $percent } %
accuracy-noise-busy = časy jsou jen hrubé, protože počítač byl příliš zaneprázdněný
accuracy-share = chyby se měřily na { $percent } % pixelů, v malých dlaždicích po celém obrázku
accuracy-reference-edges = hrany se porovnávají s obrázkem o { $samples ->
    [one] { $samples } vzorku
   *[other] { $samples } vzorcích
} na pixel, který se sám odchyluje o { $error } kroku
accuracy-checked = nezávislý sledovač paprsků se 71 číslicemi spočítal znovu { $pixels ->
    [one] { $pixels } pixel
    [few] { $pixels } pixely
   *[other] { $pixels } pixelů
} ({ $rays ->
    [one] { $rays } paprsek
    [few] { $rays } paprsky
   *[other] { $rays } paprsků
}): jeho barvy { $largest ->
    [0] jsou stejné
   *[other] se liší nejvýše o { $largest } bílé (krok je 4e-3 bílé)
}
accuracy-load = zátěž počítače { $before } předtím, { $after } potom
accuracy-written = Stránka je { $path }

accuracy-panels-alt = Diagramy práce a přesnosti: chyba na x, čas na y, obojí logaritmicky, pro každý druh chyby jeden
accuracy-head-edges = Hrany
accuracy-head-light = Zanedbané světlo
accuracy-head-numbers = Zaokrouhlování
accuracy-head-facets = Plošky
accuracy-sub-edges = kolik vzorků má pixel
accuracy-sub-light = hloubka paprsků, práh vah
accuracy-sub-numbers = jaká čísla, jaký řešič
accuracy-sub-facets = rovné plošky místo zakřivených ploch
accuracy-own-error = vlastní chyba reference
accuracy-none = nic
accuracy-table-head = | nastavení | čas CPU | × výchozí | chyba | FLIP | o > 1 | |
accuracy-markdown-head = | nastavení | čas, × výchozí | chyba, kroky | FLIP | pixely o > 1 krok | největší, kroky | |
accuracy-default = výchozí
accuracy-front = na čele
accuracy-recommended = doporučeno
accuracy-same-as = tentýž výpočet jako { $other }
accuracy-below-reference = pod vlastní chybou reference
accuracy-wrong-object = { $wrong ->
    [one] { $wrong } pixel ukazuje jiný objekt
    [few] { $wrong } pixely ukazují jiný objekt
   *[other] { $wrong } pixelů ukazuje jiný objekt
}
accuracy-ulps = vzdálenosti se liší o { $ulps } jednotky posledního místa (medián)
accuracy-uncertain = { $rays ->
    [one] { $rays } nejistý paprsek
    [few] { $rays } nejisté paprsky
   *[other] { $rays } nejistých paprsků
}
accuracy-tile-change = Co ještě nastavit
accuracy-tile-numbers = Která čísla
accuracy-tile-sure = Jak jisté to je
accuracy-section-panels = Každý druh chyby v jednom měřítku
accuracy-note-panels = Vlevo je přesnější, dole rychlejší. V každém diagramu se mění jeden druh nastavení, ostatní zůstávají. Plný bod: nic z vyzkoušeného není zároveň rychlejší i přesnější. Kroužek: výchozí. Čárkovaně: cíl. „nic“: tentýž obrázek jako reference.
accuracy-section-table = Co nastavit
accuracy-note-table = Chyba: střední kvadratická odchylka v krocích 1/255, s intervalem, ve kterém chyba celého obrázku leží s pravděpodobností 95 %. O > 1: pixely, v nichž se některý kanál liší o víc než krok. Čas CPU: celého obrázku na jednom vlákně.
accuracy-more-rows = { $left ->
    [0] Jsou tu všechna vyzkoušená nastavení.
    [one] { $left } další vyzkoušené nastavení je v accuracy.json.
    [few] { $left } další vyzkoušená nastavení jsou v accuracy.json.
   *[other] { $left } dalších vyzkoušených nastavení je v accuracy.json.
}
accuracy-section-pictures = Podívejte se
accuracy-note-pictures = Pro každý druh chyby část obrázku, kde je nejhorší: s výchozím nastavením (u zaokrouhlování v jednoduché přesnosti), s nejpřesnějším, na jaké je čas, a rozdíl obou.
accuracy-difference = rozdíl × { $factor }; největší { $largest } kroku; pixelů, které se liší o víc než krok: { $wrong }
accuracy-section-shares = Kam jde čas a kde je chyba
accuracy-note-shares = Pixel se počítá k tomu, co vidí jeho střed. Efekty se vypínají po jednom; překrývají se, takže součet podílů není celek.
accuracy-objects-head = | co je vidět | pixely | čas | chyba | µs na vzorek |
accuracy-effects-head = | vypnutý efekt | ušetřený čas | ušetřené paprsky | obrázek se změní o |
accuracy-within-noise = v šumu
accuracy-map-time = Čas vzorku, až { $most } µs
accuracy-map-error = Chyba na hranách, až { $most } kroku
accuracy-section-skipped = Co se neměřilo a proč
accuracy-section-how = Jak se měřilo
accuracy-note-how = Časy jsou nejmenší časy CPU na jednom vlákně z několika běhů v zamíchaném pořadí. Výchozí nastavení se měřilo čtyřikrát: o kolik se tato měření liší, to je šum. Chyby se měří v dvojité přesnosti, na malých dlaždicích rozložených po celém obrázku.
accuracy-shapes-head = | těleso | jak | přímky | ns na přímku | chybně | medián chyby | největší chyba | nejisté |

cost-camera = paprsky kamery
cost-shadow = stínové paprsky
cost-reflection = odražené paprsky
cost-refraction = propuštěné paprsky
cost-boxes = testy s kvádry
cost-shapes = testy s tělesy
cost-uncertain = paprsky rozhodnuté v double-double
cost-phases = čas
cost-objects = nejdražší z toho, co je vidět
cost-effect = nejdražší efekt, vypne-li se jen on
